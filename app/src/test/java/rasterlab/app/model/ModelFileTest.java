package rasterlab.app.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.texture.Wrap;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.scene.SceneSource;
import rasterlab.exercises.scene.SceneView;
import rasterlab.exercises.scene.Settings;

/** Models as other people's programs write them. */
class ModelFileTest {
    private static final Charset CP1251 = Charset.forName("windows-1251");
    private static final String PYRAMID =
            """
            v -1 -1 0
            v 1 -1 0
            v 1 1 0
            v -1 1 0
            v 0 0 2
            vt 0 0
            vt 1 0
            vt 1 1
            usemtl сталь
            f 1 2 3 4
            f 1/1 2/2 5/3
            f 2/1 3/2 5/3
            usemtl медь
            f 3/1 4/2 5/3
            f 4/1 1/2 5/3
            """;
    private static final String METALS = "newmtl сталь\nKd 0 0 1\nnewmtl медь\nKd 1 0 0\n";

    @TempDir Path folder;

    private final List<String> notes = new ArrayList<>();

    private Scene read() {
        return ModelFile.read(folder.resolve("a.obj"), UpAxis.Z, notes::add);
    }

    private void write(String name, byte[] bytes) throws IOException {
        Files.createDirectories(folder.resolve(name).getParent());
        Files.write(folder.resolve(name), bytes);
    }

    private void writePicture(String name) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        ImageIO.write(new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
    }

    static Stream<Arguments> encodings() {
        return Stream.of(
                argumentSet("UTF-8", StandardCharsets.UTF_8, "", ""),
                argumentSet("UTF-8 with a mark", StandardCharsets.UTF_8, "\uFEFF", ""),
                argumentSet(
                        "UTF-16, low byte first", StandardCharsets.UTF_16LE, "\uFEFF", "UTF-16"),
                argumentSet(
                        "UTF-16, high byte first", StandardCharsets.UTF_16BE, "\uFEFF", "UTF-16"),
                argumentSet("UTF-16 without a mark", StandardCharsets.UTF_16LE, "", "UTF-16"),
                argumentSet("Windows-1251", CP1251, "", "Windows-1251"));
    }

    @ParameterizedTest(
            name = "a model in {argumentSetName} is not read, or two names in it are one")
    @MethodSource("encodings")
    void readsEncodings(Charset charset, String mark, String told) throws IOException {
        write("a.obj", (mark + "mtllib a.mtl\n" + PYRAMID).getBytes(charset));
        write("a.mtl", (mark + METALS).getBytes(charset));
        Scene scene = read();
        assertEquals(0x0000FF, scene.finish(0).rgb());
        assertEquals(0xFF0000, scene.finish(3).rgb());
        String file = folder.resolve("a.obj") + ": ";
        assertEquals(
                told.isEmpty()
                        ? List.of()
                        : List.of(file + "is " + told + " text and was read as such"),
                notes);
        assertEquals(
                told.isEmpty() ? 0 : 1,
                notes.stream()
                        .map(note -> Complaints.translated(Language.RUSSIAN, note))
                        .filter(
                                said ->
                                        said.endsWith(
                                                "это текст в кодировке "
                                                        + told
                                                        + ", так он и прочитан"))
                        .count(),
                notes::toString);
    }

    @Test
    @DisplayName("materials in another encoding than their model are not found")
    void readsMixedEncodings() throws IOException {
        write("a.obj", ("mtllib a.mtl\n" + PYRAMID).getBytes(StandardCharsets.UTF_16BE));
        write("a.mtl", METALS.getBytes(CP1251));
        assertEquals(0xFF0000, read().finish(4).rgb());
    }

    @ParameterizedTest(name = "{0} does not find {1}")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "tex.png | tex.png",
                "TEX.PNG | tex.png",
                "Tex.png | tEX.PNG",
                "\"tex.png\" | tex.png",
                "'my tex.png' | my tex.png",
                "C:\\Users\\me\\wood.png | wood.png",
                "/home/me/Wood.png | wood.png",
                "..\\maps\\wood.png | wood.png",
                "maps/wood.png | wood.png",
                "wood.png | maps/wood.png",
                "Maps\\Wood.PNG | maps/wood.png",
                "wood#2.png | wood#2.png",
                "wood #2.png | wood #2.png",
                "./wood.png | wood.png"
            })
    void findsTextures(String named, String file) throws IOException {
        write("a.obj", ("mtllib a.mtl\nusemtl a\n" + textured()).getBytes());
        write("a.mtl", ("newmtl a\nmap_Kd " + named + "\n").getBytes());
        writePicture(file);
        assertTrue(read().finish(1).texture().isPresent(), notes::toString);
        assertEquals(List.of(), notes);
    }

    private static String textured() {
        return PYRAMID.replaceAll("usemtl .*\n", "").replace("f 1 2 3 4\n", "f 1/1 2/1 3/1 4/1\n");
    }

    @ParameterizedTest(name = "{0} stops a model, or is not told")
    @ValueSource(
            strings = {"none.png", "../up.png", "/etc/passwd", "maps", "a.obj", "pipe", "link.png"})
    void colorStandsForTexturesThatAreNotThere(String name) throws IOException {
        write("a.obj", ("mtllib a.mtl\nusemtl a\n" + textured()).getBytes());
        write("a.mtl", ("newmtl a\nKd 1 0 0\nmap_Kd " + name + "\n").getBytes());
        Files.createDirectories(folder.resolve("maps"));
        Path elsewhere = Files.createTempFile("outside", ".png");
        ImageIO.write(
                new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB), "png", elsewhere.toFile());
        Files.createSymbolicLink(folder.resolve("link.png"), elsewhere);
        Scene scene = read();
        Files.delete(elsewhere);
        assertEquals(Optional.empty(), scene.finish(1).texture());
        assertEquals(0xFF0000, scene.finish(1).rgb());
        assertEquals(1, notes.size(), notes::toString);
        assertTrue(notes.get(0).startsWith("a.mtl:3: "), notes::toString);
        assertTrue(notes.get(0).endsWith("; the colour Kd stands for it"), notes::toString);
        String russian = Complaints.translated(Language.RUSSIAN, notes.get(0));
        assertTrue(russian.endsWith("; вместо текстуры цвет Kd"), russian);
    }

    @ParameterizedTest(name = "{0} does not find a.mtl")
    @ValueSource(strings = {"A.MTL", "\"a.mtl\"", "C:\\models\\a.mtl", "./a.mtl", "../a.mtl"})
    void findsMaterials(String named) throws IOException {
        write("a.obj", ("mtllib " + named + "\n" + PYRAMID).getBytes(StandardCharsets.UTF_8));
        write("a.mtl", METALS.getBytes(StandardCharsets.UTF_8));
        assertEquals(0xFF0000, read().finish(3).rgb());
        assertEquals(List.of(), notes);
    }

    @Test
    @DisplayName("materials outside the folder are read")
    void materialsElsewhereAreNotRead(@TempDir Path elsewhere) throws IOException {
        write("a.obj", ("mtllib a.mtl\n" + PYRAMID).getBytes(StandardCharsets.UTF_8));
        Files.writeString(elsewhere.resolve("b.mtl"), METALS);
        Files.createSymbolicLink(folder.resolve("a.mtl"), elsewhere.resolve("b.mtl"));
        assertEquals(0xCCCCCC, read().finish(3).rgb());
        assertTrue(notes.get(0).endsWith("there is no material file 'a.mtl'; it was passed over"));
    }

    /** A word that may be a number or the beginning of a name is what there is a file for. */
    @ParameterizedTest(name = "map_Kd {0} does not draw {1}, or says nothing of it")
    @CsvSource(
            delimiter = '|',
            value = {
                "-o 1,5 0 0 tex.png | tex.png | '-o' has a decimal comma in '1,5'; 0 is used instead",
                "-o nan 0 0 tex.png | tex.png | '-o' has no number in 'nan'; 0 is used instead",
                "-o x 0 0 tex.png | tex.png | '-o' has no number in 'x'; 0 is used instead",
                "-o 0 0 x tex.png | tex.png | there is no texture 'x tex.png'; 'tex.png' was taken",
                "-o 0 0 x in/tex.png | in/tex.png | there is no texture 'x in/tex.png'; 'in/tex.png' was taken",
                "-o 0 0 x tex.png | x tex.png | ",
                "-o 0.5 -s 2 tex.png | tex.png | ",
                "-s 2 -o 0.5 0.25 -clamp on tex.png | tex.png | ",
                "tex.png #2 | tex.png | there is no texture 'tex.png #2'; 'tex.png' was taken",
                "tex.png #2 | tex.png #2 | ",
                "tex#2.png | tex#2.png | "
            })
    void findsTexturesBehindSpoiledOptions(String map, String file, String note)
            throws IOException {
        write("a.obj", ("mtllib a.mtl\n" + PYRAMID).getBytes(StandardCharsets.UTF_8));
        write("a.mtl", (METALS + "map_Kd " + map + "\n").getBytes(StandardCharsets.UTF_8));
        writePicture(file);
        assertTrue(read().finish(3).texture().isPresent());
        List<String> told = notes.stream().filter(said -> said.startsWith("a.mtl:5: ")).toList();
        assertEquals(note == null ? List.of() : List.of("a.mtl:5: " + note), told);
        for (String said : told)
            assertFalse(
                    Complaints.translated(Language.RUSSIAN, said)
                            .matches(".*\\b(the|has|was)\\b.*"),
                    said);
    }

    @Test
    @DisplayName("offset, scale and clamp do nothing")
    void laysTexturesAsTheirOptionsSay() throws IOException {
        write("a.obj", ("mtllib a.mtl\nusemtl a\n" + textured()).getBytes());
        write("a.mtl", "newmtl a\nmap_Kd -o 0.25 -7 0 -s 2 10 1 -clamp on t.png\n".getBytes());
        writePicture("t.png");
        Scene scene = read();
        LaidTexture laid = scene.finish(1).texture().orElseThrow();
        assertEquals(Wrap.CLAMP_TO_EDGE, laid.alongS());
        assertEquals(Wrap.CLAMP_TO_EDGE, laid.alongT());
        assertEquals(0.25, scene.mesh().textureS(1, 0));
        assertEquals(2.25, scene.mesh().textureS(1, 1));
        assertEquals(3, scene.mesh().textureT(1, 2));
    }

    @Test
    @DisplayName("a face whose plane is lost in its model's size stops the model")
    void drawsFacesThatAreTinyBesideTheirModel() throws IOException {
        write(
                "a.obj",
                (PYRAMID
                                + "v 1e9 1e9 1e9\nv 5e-3 0 0\nv 0 5e-3 0\nv 0 0 5e-3\nv 5e-3 -5e-3 5e-3\n"
                                + "f 6 1 2\nf 7 8 9 10\n")
                        .getBytes(StandardCharsets.UTF_8));
        assertTrue(read().mesh().faceCount() >= 6, notes::toString);
    }

    @Test
    @DisplayName(
            "colours of vertices are passed over, mixed along a line, or lost in a saved scene")
    void drawsColorsOfVertices() throws IOException {
        write("a.obj", "v 0 0 0 1 0 0\nv 2 0 0 0 1 0\nv 0 2 1\nf 1 2 3\nl 1 2\n".getBytes());
        Scene scene = read();
        assertEquals(1, scene.mesh().color(0, 0, 0));
        assertEquals(0, scene.mesh().color(0, 1, 0));
        assertEquals(1, scene.mesh().color(0, 2, 2));
        assertEquals(0, scene.mesh().color(1, 0, 1), "the line's first end");
        assertEquals(1, scene.mesh().color(1, 2, 1), "its second end");
        String text =
                new SceneView(new SceneSource.Inline(scene), Settings.NONE).write().toString();
        SceneView again = (SceneView) SceneFile.read(text);
        assertEquals(1, again.source().scene().mesh().color(1, 2, 1));
    }

    @Test
    @DisplayName("lines and points are passed over")
    void drawsLinesAndPoints() throws IOException {
        write(
                "a.obj",
                "mtllib a.mtl\nv 0 0 0\nv 2 0 0\nv 0 2 1\nusemtl a\nl 1 2 3\np -1 1\n".getBytes());
        write("a.mtl", "newmtl a\nKd 1 0 0\nd 0\n".getBytes());
        Scene scene = read();
        assertEquals(List.of(), notes);
        assertEquals(2 * 3 + 2 * 8, scene.mesh().faceCount());
        for (int f = 0; f < scene.mesh().faceCount(); f++) {
            assertEquals(0xFF0000, scene.finish(f).rgb());
            assertEquals(1, scene.finish(f).front().alpha());
        }
    }

    @Test
    @DisplayName("a decimal comma, or a file of no model, is not named")
    void refusesByName() throws IOException {
        write("a.obj", "v 0,0 0,0 2,0\n".getBytes());
        assertEquals(
                folder.resolve("a.obj")
                        + ":1: 'v' has a decimal comma in number 1, '0,0'; decimals are written with"
                        + " a point",
                assertThrows(Complaint.class, this::read).getMessage());
        write("a.obj", "v 0 0 0\np 1\n".getBytes());
        assertFalse(read().mesh().faceCount() == 0);
    }
}
