#!/usr/bin/env python3
"""doc_filter.py - turns the comments of a public header into what Doxygen understands.

Usage: doc_filter.py HEADER, which prints the header with
- its first line, `// film.h - planes of a picture.`, as the description of the file;
- `// ...` behind a member, and on the lines that continue it, as the member's description;
- facts of a `///` block, `throws  ArgumentError: ...` (a label, two spaces or more, text; further lines are
  indented), as a list. A new kind of error begins a new line of its fact;
- deleted functions and destructors left out: there is nothing to say about them.
Lines keep their numbers, so that warnings point at the header.
"""
import re
import sys

FACT = re.compile(r"^(\w[\w\[\], ]*?) {2,}(\S.*)$")
ERROR = re.compile(r"^\w+Error: ")


def split_comment(line):
    """A line's code and where its `//` comment starts, outside of strings; None where there is none."""
    quoted = False
    for k, letter in enumerate(line):
        if letter == '"' and (k == 0 or line[k - 1] != "\\"):
            quoted = not quoted
        elif not quoted and line.startswith("//", k):
            return line[:k], k
    return line, None


def convert_block(lines):
    """A `///` block: its facts become a list, whose tags stay on the lines that they belong to."""
    texts = [line.strip()[3:] for line in lines]
    out = []
    last = None  # the line that the open fact ends on
    for text in texts:
        body = text.strip()
        fact = FACT.match(text[1:]) if text.startswith(" ") else None
        if fact:
            tag = "</dd>" if last is not None else '<dl class="facts">'
            body = f"{tag}<dt>{fact[1]}</dt><dd>{fact[2]}"
            last = len(out)
        elif last is not None and body:
            if text.startswith("  "):
                last = len(out)
                if ERROR.match(body):
                    body = "<br>" + body
            else:  # plain text again
                out[last] += "</dd></dl>"
                last = None
        out.append(body)
    if last is not None:
        out[last] += "</dd></dl>"
    indent = lines[0][: len(lines[0]) - len(lines[0].lstrip())]
    return [f"{indent}/// {body}".rstrip() for body in out]


def convert(lines):
    """The lines of a header, as Doxygen shall see them."""
    out = []
    block = []
    column = None  # of the comment behind the member above
    for number, line in enumerate(lines):
        if line.lstrip().startswith("///"):
            block.append(line)
            column = None
            continue
        out += convert_block(block) if block else []
        block = []
        code, at = split_comment(line)
        head = re.match(r"// (\S+\.h) - (.*)$", line) if number == 0 else None
        if head:
            line = f"/** @file {head[1]} @brief {head[2][:1].upper()}{head[2][1:]} */"
        elif re.search(r"= delete;|^\s*~\w+\(", code):
            line = ""
        elif at is None:
            column = None
        elif not code.strip():
            line = f"{code}///<{line[at + 2:]}" if at == column else line
        elif code.rstrip()[-1] in ";,{":
            column = at
            line = f"{code}///<{line[at + 2:]}"
        out.append(line)
    return out + (convert_block(block) if block else [])


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as header:
        print("\n".join(convert(header.read().split("\n"))), end="")
