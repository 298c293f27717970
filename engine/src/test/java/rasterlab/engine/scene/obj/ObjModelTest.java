package rasterlab.engine.scene.obj;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class ObjModelTest {
    /** Faces by the numbers of their corners, as text. */
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void readsFaces(String obj, String faces) throws Exception {
        ObjModel model = Texts.read(obj);
        var found = new StringBuilder();
        for (int f = 0; f < model.faceCount(); f++) {
            if (f > 0) found.append(" | ");
            for (int k = 0; k < model.cornerCount(f); k++)
                found.append(k > 0 ? " " : "").append(model.position(f, k));
        }
        assertEquals(faces, found.toString());
    }

    static Stream<Arguments> mistakes() {
        String bent = "v 0 0 0\nv 4 0 0\nv 4 4 1\nv 0 4 0\n";
        String arrow = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\n";
        return Stream.of(
                read("a polygon is cut", "f 1 2 3 4", "0 1 2 3"),
                read("−1 is the first vertex", "f -4 -3 -2 -1", "0 1 2 3"),
                read(
                        "−1 is counted from the file's end",
                        "f -4 -3 -2\nv 9 9 9\nv 9 9 8\nv 9 8 9\nf -3 -2 -1",
                        "0 1 2 | 4 5 6"),
                read(
                        "a carriage return is part of the number",
                        "f 1 2 3\r\nf 1 3 4\r\n",
                        "0 1 2 | 0 2 3"),
                read("a lone carriage return ends no line", "f 1 2 3\rf 1 3 4\r", "0 1 2 | 0 2 3"),
                read("a continued line is cut off", "f 1 2 \\\n 3 \\\r\n 4", "0 1 2 3"),
                read("a continued line joins words", "f 1 2\\\n3 4", "0 1 2 3"),
                read("a backslash in a comment continues it", "# a \\\nf 1 2 3", "0 1 2"),
                read("a comment behind the corners is read", "f 1 2 3 # 4", "0 1 2"),
                read("tabs do not divide words", "\tf\t1  2\t3 \t", "0 1 2"),
                read("a corner listed twice makes a triangle", "f 1 2 2 3 4 1", "0 1 2 3"),
                read("a face without area is let in", "f 1 2 2\nf 1 2 3", "0 1 2"),
                argumentSet(
                        "a byte order mark is a keyword",
                        "\uFEFF" + Texts.SQUARE + "f 2 3 4",
                        "1 2 3"),
                argumentSet("a bent face is let in", bent + "f 1 2 3 4", "3 0 1 | 3 1 2"),
                argumentSet(
                        "a sliver that cutting makes is let in",
                        "v 0 0 0\nv 2 -1e-12 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4 5",
                        "0 2 3 | 0 3 4"),
                argumentSet("a face is cut outside", arrow + "f 1 2 3 4", "0 1 2 | 0 2 3"),
                argumentSet("cutting turns a face over", arrow + "f 4 3 2 1", "0 3 2 | 0 2 1"));
    }

    private static Arguments read(String mistake, String more, String faces) {
        return argumentSet(mistake, Texts.SQUARE + more, faces);
    }

    @Test
    @DisplayName("what is passed over is not told, or told each time")
    void notesWhatItPassedOver() throws Exception {
        ObjModel model =
                Texts.read(
                        Texts.SQUARE
                                + "f 1 2 2\nlod 3\nf 1 2 3\nf 3 4 3\nlod 4\nl 1 2\no box\ng a b\n"
                                + "v 9 9 9 0.5\n");
        assertEquals(
                List.of(
                        "a.obj:5: face without area or too thin to be seen was left out (2 times)",
                        "a.obj:6: 'lod' was passed over; faces, lines and points are read (2 times)",
                        "a.obj:13: a vertex's weight, which means nothing to faces, was passed over"),
                model.notes());
    }

    @Test
    @DisplayName("each of any number of unknown words makes a note")
    void notesEndSomewhere() throws Exception {
        var text = new StringBuilder(Texts.SQUARE + "f 1 2 3\n");
        for (int i = 0; i < 60; i++) text.append("x").append(i).append('\n');
        List<String> notes = Texts.read(text.toString()).notes();
        assertEquals(51, notes.size());
        assertEquals("a.obj:56: other unknown keywords were passed over (10 times)", notes.get(50));
    }

    @Test
    @DisplayName("a colour moves to another vertex")
    void colorsStayWithTheirVertices() throws Exception {
        ObjModel model =
                Texts.read("v 0 0 0\nv 1 0 0 0.5 0 1\nv 0 1 0 1 0 0 1\nv 1 1 1\nf 1 2 3\nf 2 4 3");
        assertArrayEquals(new double[] {1, 1, 1, 0.5, 0, 1, 0, 0, 1, 1, 1, 1}, model.colors());
    }

    @Test
    @DisplayName("a material keeps the values of the one before")
    void readsMaterials() throws Exception {
        ObjModel model =
                Texts.read(
                        "mtllib m.mtl\n" + Texts.SQUARE + "f 1 2 3",
                        "newmtl a\r\nKa 0.1 0.2 0.3\nKd 0.4\nKs 0.5 0.6 0.7\nKe 2 0 0\nNs 96.5\n"
                                + "Tr 0.25\nillum 1\nmap_Kd my wood.png # old\nnewmtl b\nd 0.5\n"
                                + "Pr 0.5\n");
        assertEquals(
                new ObjMaterial(
                        "a",
                        List.of(0.1, 0.2, 0.3),
                        List.of(0.4, 0.4, 0.4),
                        List.of(0.5, 0.6, 0.7),
                        List.of(2.0, 0.0, 0.0),
                        96.5,
                        0.75,
                        Optional.of(
                                new ObjMaterial.Map(
                                        List.of("my wood.png # old", "my wood.png"),
                                        "m.mtl:9",
                                        List.of(0.0, 0.0),
                                        List.of(1.0, 1.0),
                                        false)),
                        1),
                model.materials().get(0));
        assertEquals(0.5, model.materials().get(1).opacity());
        assertEquals(0, model.materials().get(1).shininess());
        assertEquals("", model.materials().get(model.material(0)).name());
        assertEquals(List.of("m.mtl:12: 'Pr' was passed over"), model.notes());
    }

    @Test
    @DisplayName("a material file's name ends at its blank")
    void findsFilesWithBlanks() throws Exception {
        String rest = "\n" + Texts.SQUARE + "usemtl wood\nf 1 2 3";
        assertEquals("wood", firstMaterial(Texts.read("mtllib my m.mtl" + rest)));
        var both = Texts.read("mtllib m.mtl m.mtl\n" + Texts.SQUARE + "usemtl red\nf 1 2 3");
        assertEquals("red", firstMaterial(both));
    }

    private static String firstMaterial(ObjModel model) {
        return model.materials().get(model.material(0)).name();
    }

    /** Two sides of a roof that share the ridge. */
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("smoothing")
    void addsMissingNormals(String first, String second, boolean smooth) throws Exception {
        String roof = "v -1 0 0\nv -1 1 0\nv 0 0 1\nv 0 1 1\nv 1 0 0\nv 1 1 0\n";
        ObjModel model = Texts.read(roof + first + "\nf 1 3 4 2\n" + second + "\nf 3 5 6 4\n");
        double[] normals = model.normals();
        double left = normals[3 * model.normal(0, 1)];
        double right = normals[3 * model.normal(1, 0)];
        assertEquals(smooth ? 0 : -Math.sqrt(0.5), left, 1e-15);
        assertEquals(smooth ? 0 : Math.sqrt(0.5), right, 1e-15);
        assertEquals(-Math.sqrt(0.5), normals[3 * model.normal(0, 0)], 1e-15);
        for (int i = 0; i < normals.length; i += 3) assertTrue(normals[i + 2] > 0);
    }

    static Stream<Arguments> smoothing() {
        return Stream.of(
                argumentSet("faces are smooth without being told so", "", "", false),
                argumentSet("smoothing does nothing", "s 1", "", true),
                argumentSet("smoothing cannot be turned off", "s 1", "s off", false),
                argumentSet("groups are joined", "s 1", "s 2", false),
                argumentSet("group 0 is smooth", "s 0", "s 0", false));
    }

    @Test
    @DisplayName("front and back of one sheet have no normal")
    void sheetsKeepTheirFacesNormals() throws Exception {
        ObjModel model = Texts.read(Texts.SQUARE + "s 1\nf 1 2 3 4\nf 4 3 2 1");
        assertEquals(1, model.normals()[3 * model.normal(0, 0) + 2]);
        assertEquals(-1, model.normals()[3 * model.normal(1, 0) + 2]);
    }

    /** A strip of squares; one that took time by the square of its size would take hours. */
    @Test
    @DisplayName("reading takes time by the square of the size")
    void readsManyFaces() throws Exception {
        int squares = 50_000;
        var text = new StringBuilder("s 1\nv 0 0 0\nv 0 1 0\n");
        for (int i = 1; i <= squares; i++)
            text.append("v %d 0 0\nv %d 1 0\ns %d\nf -4 -2 -1 -3\n".formatted(i, i, i % 7 + 1));
        ObjModel model = Texts.read(text.toString());
        assertEquals(squares, model.faceCount());
    }
}
