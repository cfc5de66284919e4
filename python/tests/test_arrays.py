"""Arrays of all kinds in, and clear errors for those that cannot be."""

import numpy as np
import pytest

import firsthit as fh

VERTICES = np.array([[-1, -1, 0], [1, -1, 0], [0, 1, 0.5]], np.float32)
TRIANGLES = np.array([[0, 1, 2]], np.uint32)


def positions(vertices, triangles=TRIANGLES):
    return np.array(fh.Scene(vertices, triangles).pose().positions)


def test_all_layouts_and_types_mean_the_same():
    wanted = positions(VERTICES)
    wide = np.zeros((6, 3), np.float32)
    wide[::2] = VERTICES
    for given in (VERTICES.astype(np.float64), np.asfortranarray(VERTICES), wide[::2], VERTICES.tolist(),
                  VERTICES.astype(">f4"), VERTICES.astype(">f8"), VERTICES[::-1][::-1], VERTICES.astype(np.float16)):
        assert np.array_equal(positions(given), wanted)
    for given in (TRIANGLES.astype(np.int64), TRIANGLES.astype(np.uint8), TRIANGLES.tolist(), TRIANGLES.astype(">i4"),
                  TRIANGLES.astype(np.uint64), np.asfortranarray(TRIANGLES)):
        assert np.array_equal(positions(VERTICES, given), wanted)


class ByInterface:
    def __init__(self, array):
        self.array = array
        self.__array_interface__ = array.__array_interface__


class ByDlpack:
    def __init__(self, array):
        self.array = array

    def __dlpack__(self, **words):
        return self.array.__dlpack__(**words)

    def __dlpack_device__(self):
        return self.array.__dlpack_device__()


@pytest.mark.parametrize("kind", [ByInterface, ByDlpack, memoryview])
def test_other_arrays_are_taken(kind):
    assert np.array_equal(positions(kind(VERTICES)), positions(VERTICES))


def test_arrays_go_out_by_dlpack(square, front):
    frame = fh.render(square.pose(), front, ["depth"])
    assert np.array_equal(np.from_dlpack(frame["depth"]), frame["depth"])


@pytest.mark.parametrize("vertices, words", [
    (np.zeros((3, 2), np.float32), ["vertices", "float32 (3, 2)", "float32 (N, 3)"]),
    (np.zeros(9), ["vertices", "float64 (9,)", "(N, 3)"]),
    (np.zeros((1, 3, 3)), ["vertices", "(1, 3, 3)"]),
    (np.float32(1), ["vertices", "()"]),
])
def test_a_wrong_shape_is_named(vertices, words):
    with pytest.raises(ValueError) as error:
        fh.Scene(vertices, TRIANGLES)
    for word in words:
        assert word in str(error.value)


@pytest.mark.parametrize("vertices", ["text", None, object(), np.array([["a", "b", "c"]]), [[1, 2, 3], [4]],
                                      np.zeros((3, 3), np.complex64), np.zeros((3, 3), object), {"a": 1}])
def test_what_is_no_array_of_numbers_is_refused(vertices):
    with pytest.raises((TypeError, ValueError)):
        fh.SceneBuilder().add_mesh(vertices, TRIANGLES)
        fh.Scene(vertices, TRIANGLES)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e300])
def test_coordinates_that_are_not_finite_are_refused(bad):
    vertices = VERTICES.astype(np.float64)
    vertices[1, 1] = bad
    with pytest.raises(fh.SceneError):
        fh.Scene(vertices, TRIANGLES)


@pytest.mark.parametrize("triangles", [[[0, 1, 3]], [[0, 1, -1]], [[0, 1, 2**32 - 1]], [[0, 1, 2**32]], [[0, 1, 2**63]],
                                       [[0, 1, 2**64 - 1]]])
def test_indices_out_of_range_are_refused(triangles):
    with pytest.raises((ValueError, TypeError)) as error:  # NumPy makes floats of the largest
        fh.Scene(VERTICES, np.array(triangles))
    assert str(error.value)


def test_indices_that_are_no_whole_numbers_are_refused():
    with pytest.raises(TypeError, match="whole numbers"):
        fh.Scene(VERTICES, [[0.0, 1.0, 2.0]])


@pytest.mark.parametrize("name, count", [("normals", 3), ("uv", 2), ("colors", 4)])
def test_one_for_each_vertex(name, count):
    with pytest.raises(ValueError, match=name):
        fh.Scene(VERTICES, TRIANGLES, **{name: np.ones((2, count), np.float32)})


class Liar:
    """Says that it has more than its 36 bytes. NumPy believes it."""

    def __init__(self, shape, **words):
        self.__array_interface__ = {"shape": shape, "typestr": "<f4", "version": 3, "data": VERTICES.tobytes(), **words}


def test_an_object_that_lies_about_its_size_is_refused():
    assert np.array_equal(positions(Liar((3, 3))), positions(VERTICES))
    for liar in (Liar((4, 3)), Liar((2**40, 3)), Liar((3, 3), strides=(4096, 4)), Liar((3, 3), strides=(-12, 4)),
                 Liar((3, 3), offset=4)):
        with pytest.raises(ValueError, match="memory is smaller|at most"):
            fh.Scene(liar, TRIANGLES)
    # What NumPy makes of buffers is in them.
    data = np.frombuffer(VERTICES.tobytes(), np.float32).reshape(3, 3)
    for honest in (data, data[::-1], memoryview(np.repeat(VERTICES, 2, 0))[::2], memoryview(bytearray(8))):
        if np.asarray(honest).shape == (3, 3):
            fh.Scene(honest, TRIANGLES)


class NoCapsule:
    def __dlpack__(self, **words):
        return 5

    def __dlpack_device__(self):
        return (1, 0)


class NoArray:
    def __array__(self, dtype=None):
        return [1, 2, 3]


class Endless:
    def __len__(self):
        return 3

    def __getitem__(self, k):
        raise ZeroDivisionError("no element")


class NotThere:
    __array_interface__ = {"shape": (3, 3), "typestr": "<f4", "version": 3}


@pytest.mark.parametrize("kind", [NoCapsule, NoArray, Endless, NotThere])
def test_objects_that_break_their_promises_are_refused(kind):
    for call in (lambda: fh.Scene(kind(), TRIANGLES), lambda: fh.Scene(VERTICES, kind()),
                 lambda: fh.occlusion(fh.Scene(VERTICES, TRIANGLES).pose(), kind(), directions=[[0, 0, 1]])):
        with pytest.raises((TypeError, ValueError, ZeroDivisionError)):
            call()


def test_more_rows_than_ids_are_refused_before_they_are_copied():
    # Arrays without memory: one row, again and again.
    many = np.broadcast_to(np.zeros(3, np.float32), (2**33, 3))
    with pytest.raises(ValueError, match="at most"):
        fh.Scene(many, TRIANGLES)
    with pytest.raises(ValueError, match="at most"):
        fh.Scene(VERTICES, np.broadcast_to(np.zeros(3, np.uint32), (2**32, 3)))
    with pytest.raises(ValueError, match="at most"):
        fh.occlusion(fh.Scene(VERTICES, TRIANGLES).pose(), many, directions=[[0, 0, 1]])


def test_nothing_is_a_scene_of_nothing(front):
    for vertices, triangles in (([], []), (np.zeros((0, 3)), np.zeros((0, 3), int)), (VERTICES, [])):
        frame = fh.render(fh.Scene(vertices, triangles).pose(), front, ["item", "depth"])
        assert (frame["item"] == fh.NO_ID).all()
        assert np.isinf(frame["depth"]).all()


def test_colours_are_linear_floats_or_srgb_bytes():
    camera = fh.look_at(eye=(0, 0, 3), target=(0, 0, 0), size=(9, 9))
    material = fh.Material(model="unlit", color=(1, 1, 1))
    pictures = []
    for colors in (np.full((3, 3), 0.21586050, np.float32), np.full((3, 3), 128, np.uint8)):
        world = fh.Scene(VERTICES, TRIANGLES, colors=colors, material=material).pose()
        pictures.append(fh.render(world, camera, aa=1)["color"][4, 4])
    assert pictures[0] == pytest.approx([0.21586] * 3, abs=1e-5)
    assert pictures[1] == pytest.approx(pictures[0], abs=1e-6)
    with pytest.raises(ValueError, match="colors"):
        fh.Scene(VERTICES, TRIANGLES, colors=np.full((3, 3), 300))
