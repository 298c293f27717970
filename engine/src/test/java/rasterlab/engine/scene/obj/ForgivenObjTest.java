package rasterlab.engine.scene.obj;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Reads models that lack things they can do without: the faces that are left, and the one note. */
class ForgivenObjTest {
    private static final String NO_DIRECTION =
            "a normal without a direction was passed over; where it is named the face has its own";
    private static final String FAN =
            "a face that crosses itself, or has too many corners to be cut, was drawn as a fan of"
                    + " triangles";

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("things")
    void readsTheRest(String more, String faces, List<String> notes) throws Exception {
        ObjModel model = Texts.read(Texts.SQUARE + more);
        assertEquals(faces, faces(model));
        assertEquals(notes, model.notes());
    }

    /** Corners as v/vt, or v alone; a normal as n where it is not the face's own. */
    private static String faces(ObjModel model) {
        List<String> faces = new ArrayList<>();
        for (int f = 0; f < model.faceCount(); f++) {
            List<String> corners = new ArrayList<>();
            for (int k = 0; k < model.cornerCount(f); k++) {
                int place = model.texturePlace(f, k);
                double z = model.normals()[3 * model.normal(f, k) + 2];
                corners.add(
                        model.position(f, k)
                                + (place < 0 ? "" : "/" + place)
                                + (Math.abs(z) == 1 ? "" : "n"));
            }
            faces.add(String.join(" ", corners));
        }
        return String.join(" | ", faces);
    }

    private static Arguments thing(String mistake, String more, String faces, String... notes) {
        return argumentSet(mistake, more, faces, List.of(notes));
    }

    static Stream<Arguments> things() {
        return Stream.of(ofFaces(), ofNumbers(), ofMaterials()).flatMap(things -> things);
    }

    private static Stream<Arguments> ofFaces() {
        String tilted = "vn 1 0 1\nvt 0 0\nvt 1 1\n";
        return Stream.of(
                thing("an empty place is a fault", "f 1/ 2/ 3/", "0 1 2"),
                thing("empty place and normal are a fault", "f 1// 2// 3//", "0 1 2"),
                thing("an empty normal is a fault", tilted + "f 1/1/ 2/2/ 3/2/", "0/0 1/1 2/1"),
                thing(
                        "normal 0 stops a model",
                        tilted + "f 1//0 2//0 3//0",
                        "0 1 2",
                        "a.obj:8: face corner 1 names normal 0, which is not there; it was passed"
                                + " over (3 times)"),
                thing(
                        "a place that is not there stops a model",
                        "f 1/1 2/1 3/1",
                        "0 1 2",
                        "a.obj:5: face corner 1 names texture place 1, which is not there; it was"
                                + " passed over (3 times)"),
                thing(
                        "a normal that is not there takes those of the others away",
                        tilted + "f 1//1 2//1 3//2",
                        "0n 1n 2",
                        "a.obj:8: face corner 3 names normal 2, which is not there; it was passed"
                                + " over"),
                thing(
                        "corners of two forms stop a model",
                        tilted + "f 1/1/1 2//1 3/1 4",
                        "0n 1n 2 3",
                        "a.obj:8: places of a texture that some corners of a face lack were passed"
                                + " over"),
                thing(
                        "a slash too many stops a model",
                        tilted + "f 1/1/1/7 2/1/1 3/2/1",
                        "0/0n 1/0n 2/1n",
                        "a.obj:8: a face corner's numbers after v/vt/vn were passed over"),
                thing(
                        "two corners stop a model",
                        "f 1 2\nf 1 2 3",
                        "0 1 2",
                        "a.obj:5: a face of fewer than 3 corners was left out"),
                thing(
                        "halves that cancel out are left out unseen",
                        "f 1 3 2 4",
                        "0 2 1 | 0 1 3",
                        "a.obj:5: " + FAN),
                thing(
                        "a face that crosses itself stops a model",
                        "v 9 1 0\nf 1 3 5 4",
                        "0 2 4 | 0 4 3",
                        "a.obj:6: " + FAN),
                thing(
                        "a hole on a bridge is filled",
                        "v 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\nf 1 2 3 4 1 5 6 7 8 5",
                        "4 0 1 | 3 0 4 | 3 4 5 | 3 5 6 | 7 4 1 | 7 1 2 | 2 3 6 | 2 6 7",
                        "a.obj:9: a face that is not flat or not convex was cut into triangles"));
    }

    /** A comb; the largest that is cut, and one of which no more than a fan is made. */
    @ParameterizedTest(name = "a comb of {0} corners stops a model, or is a fan without need")
    @CsvSource({"4002, false", "20002, true"})
    void cutsFacesOfManyCorners(int corners, boolean fan) throws Exception {
        var text = new StringBuilder();
        var face = new StringBuilder("f 1");
        text.append("v 0 -1 0\nv %d -1 0\n".formatted(corners));
        for (int i = corners - 3; i >= 0; i--) text.append("v %d %d 0\n".formatted(i, i % 2 * 5));
        for (int i = 2; i <= corners; i++) face.append(' ').append(i);
        ObjModel model = Texts.read(text.append(face).toString());
        String note = fan ? FAN : "a face that is not flat or not convex was cut into triangles";
        assertEquals("a.obj:" + (corners + 1) + ": " + note, model.notes().get(0));
        if (!fan) assertEquals(corners - 2, model.faceCount());
    }

    private static Stream<Arguments> ofNumbers() {
        return Stream.of(
                thing(
                        "a normal without length is divided by 0",
                        "vn 0 0 0\nf 1//1 2//1 3//1",
                        "0 1 2",
                        "a.obj:5: " + NO_DIRECTION),
                thing(
                        "a normal that nobody names stops a model",
                        "vn 0 0 0\nf 1 2 3",
                        "0 1 2",
                        "a.obj:5: " + NO_DIRECTION),
                thing(
                        "what Windows writes for no number is a comment",
                        "vn -1.#IND00 -1.#IND00 -1.#IND00\nvn nan 0 1\nvn 1 1\nf 1//1 2//2 3//3",
                        "0 1 2",
                        "a.obj:5: " + NO_DIRECTION + " (3 times)"),
                thing(
                        "a place without numbers moves the ones after it",
                        "vt\nvt 1,5 x\nvt 1e30 0\nf 1/1 2/2 3/3",
                        "0/0 1/1 2/2",
                        "a.obj:5: 'vt' has too few numbers; 0 is used instead (4 times)",
                        "a.obj:7: 'vt' of 1e30 was cut to its range, -1.0E18 to 1.0E18"),
                thing(
                        "half a colour stops a model",
                        "v 0 0 1 0.5 0.5\nf 1 2 3",
                        "0 1 2",
                        "a.obj:5: a vertex's numbers without a meaning were passed over"),
                thing(
                        "a colour of 255 stops a model",
                        "v 0 0 1 255 0 x\nf 1 2 3",
                        "0 1 2",
                        "a.obj:5: vertices without a colour, beside others with one, became white",
                        "a.obj:5: 'v' of 255 was cut to its range, 0 to 1",
                        "a.obj:5: 'v' has no number in 'x'; 1 is used instead"),
                thing("smoothing cannot be on", "s on\nf 1 2 3", "0 1 2"),
                thing(
                        "smoothing that means nothing stops a model",
                        "s maybe\ns 1.5\nf 1 2 3",
                        "0 1 2",
                        "a.obj:5: 's' has no number in 'maybe'; 0 is used instead (2 times)"));
    }

    private static Stream<Arguments> ofMaterials() {
        return Stream.of(
                thing(
                        "a missing material file stops a model",
                        "mtllib lost.mtl\nmtllib\nf 1 2 3",
                        "0 1 2",
                        "a.obj:5: there is no material file 'lost.mtl'; it was passed over (2 times)"),
                thing(
                        "a missing material stops a model",
                        "mtllib m.mtl\nusemtl green\nf 1 2 3\nusemtl (null)\nusemtl\nf 2 3 4",
                        "0 1 2 | 1 2 3",
                        "a.obj:6: there is no material 'green'; the default one stands for it"
                                + " (3 times)"),
                thing(
                        "a file named below its use is not read",
                        "usemtl red\nmtllib m.mtl\nf 1 2 3",
                        "0 1 2"),
                thing(
                        "a curve stops a model, or is left out unseen",
                        "curv 0 1 1 2\ncall x\nf 1 2 3\ncurv 0 1 1 2",
                        "0 1 2",
                        "a.obj:5: 'curv' was passed over; faces, lines and points are read (2 times)",
                        "a.obj:6: 'call' was passed over; faces, lines and points are read"),
                thing(
                        "a line whose vertex is not there stops a model",
                        "l 1 9\np\nf 1 2 3",
                        "0 1 2",
                        "a.obj:5: 'l' was left out: face corner 2 names vertex 9; there are 4",
                        "a.obj:6: 'p' of too few vertices was left out"));
    }
}
