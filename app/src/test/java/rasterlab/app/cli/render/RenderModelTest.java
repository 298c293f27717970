package rasterlab.app.cli.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;
import rasterlab.engine.pipeline.Renderer;

class RenderModelTest {
    private static final String CUBE =
            """
            mtllib cube.mtl
            v 0 0 0
            v 1 0 0
            v 1 1 0
            v 0 1 0
            v 0 0 1
            v 1 0 1
            v 1 1 1
            v 0 1 1
            vt 0 0
            vt 1 0
            vt 1 1
            vt 0 1
            usemtl red
            f 4 3 2 1
            f 5 6 7 8
            usemtl pictured
            f 1/1 2/2 6/3 5/4
            f 2/1 3/2 7/3 6/4
            f 3/1 4/2 8/3 7/4
            f 4/1 1/2 5/3 8/4
            """;
    private static final String MATERIALS =
            """
            newmtl red
            Kd 1 0 0
            newmtl pictured
            Kd 1 1 1
            map_Kd textures/grid.png
            """;

    private static final String PYRAMID =
            """
            v -%1$s -%1$s 0
            v %1$s -%1$s 0
            v %1$s %1$s 0
            v -%1$s %1$s 0
            v 0 0 %2$s
            f 1 2 3 4
            f 1 2 5
            f 2 3 5
            f 3 4 5
            f 4 1 5
            """;

    @TempDir Path folder;

    @Test
    void materialsAndTexturesBesideTheModelAreSeen() throws Exception {
        model(CUBE, MATERIALS, 2, 2);
        BufferedImage picture = picture("--visibility", "raycast", "--up", "z");
        int top = picture.getRGB(80, 33);
        assertTrue((top >> 16 & 255) > 50 && (top & 0xFFFF) < 0x1010, "upper side: " + top);
        assertFalse((picture.getRGB(80, 78) & 0x00FF00) == 0, "the texture is not on the side");
    }

    /** A power of two changes no bit, and the middle is taken away. */
    @Test
    void pictureDoesNotDependOnUnitsOrPlace() throws Exception {
        model(CUBE, MATERIALS, 2, 2);
        BufferedImage picture = picture();
        model(CUBE.replaceAll("(?m)^v (\\d) (\\d) (\\d)$", "v 256$1 512$2 128$3"), MATERIALS, 2, 2);
        assertSame(picture, picture());
        for (String unit : List.of("e-12", "e5", "e15")) {
            String scaled = "v $1" + unit + " $2" + unit + " $3" + unit;
            model(CUBE.replaceAll("(?m)^v (\\d) (\\d) (\\d)$", scaled), MATERIALS, 2, 2);
            assertEquals(height(picture), height(picture()), 0.02 * height(picture), unit);
        }
    }

    @Test
    @DisplayName("a unit of 0.9 makes a model twice as large")
    void pictureIsAsLargeInEveryUnit() throws Exception {
        model(PYRAMID.formatted("1", "2"), "", 2, 2);
        int height = height(picture());
        for (String[] unit : new String[][] {{"0.9", "1.8"}, {"0.7", "1.4"}, {"25.4", "50.8"}}) {
            model(PYRAMID.formatted(unit[0], unit[1]), "", 2, 2);
            assertEquals(height, height(picture()), 0.02 * height, unit[0]);
        }
        assertTrue(height > 40 && height < 100, "height " + height + " of 120");
    }

    /** Rows in which something is seen. */
    private static int height(BufferedImage picture) {
        int background = picture.getRGB(0, 0);
        int rows = 0;
        for (int y = 0; y < picture.getHeight(); y++)
            for (int x = 0; x < picture.getWidth(); x++)
                if (picture.getRGB(x, y) != background) {
                    rows++;
                    break;
                }
        return rows;
    }

    /** The way up is y unless told: the cube laid on its side is the same again with z up. */
    @Test
    void upMayBeZ() throws Exception {
        model(CUBE, MATERIALS, 2, 2);
        BufferedImage upright = picture("--up", "z");
        assertFalse(Arrays.equals(pixels(upright), pixels(picture())), "the cube lies on its side");
        model(CUBE.replaceAll("(?m)^v (\\d) (\\d) (\\d)$", "v $1 $3 -$2"), MATERIALS, 2, 2);
        assertSame(upright, picture("--up", "y"));
        assertSame(upright, picture());
        render("--up", "x")
                .assertComplains(2, "./lab render: no axis that points up 'x'; there are y, z");
    }

    private static int[] pixels(BufferedImage picture) {
        return picture.getRGB(
                0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
    }

    @Test
    void everyVisibilityMethodDrawsOrRefusesIt() throws Exception {
        model(CUBE, MATERIALS, 3, 5);
        for (String visibility : Renderer.visibilities()) {
            Ran ran = render("--visibility", visibility);
            if (ran.exitCode() != 3) ran.assertDone();
        }
    }

    @Test
    @DisplayName("a note is in English behind a Russian label")
    void whatIsLeftOutIsToldInRussian() throws Exception {
        model(CUBE + "f 1 1 2\nf 1 1 2\nfoo 1\n", MATERIALS, 1, 1);
        Ran ran = render("--lang", "ru");
        ran.assertDone();
        String said = ran.err().replace(folder.toString(), "");
        assertTrue(
                said.contains(": грань без площади или слишком тонкая пропущена, таких мест: 2"),
                said);
        assertTrue(said.contains(": неизвестное «foo» пропущено"), said);
        assertTrue(said.contains(": осью вверх считается y; если"), said);
        assertFalse(said.contains("was"), said);
    }

    @Test
    void whatIsLeftOutIsTold() throws Exception {
        model(CUBE + "f 1 1 2\n", MATERIALS, 1, 1);
        Ran ran = render("--up", "y");
        ran.assertDone();
        String place = folder.resolve("cube.obj") + ":" + (CUBE.lines().count() + 1);
        assertEquals(
                "note: "
                        + place
                        + ": face without area or too thin to be seen was left out"
                        + System.lineSeparator(),
                ran.err());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("broken")
    void complainsInOneLine(String model, String materials, String complaint) throws Exception {
        model(model, materials, 2, 2);
        String message = complaint.replace("CUBE", folder.resolve("cube.obj").toString());
        render().assertComplains(2, "./lab render: " + message);
    }

    static Stream<Arguments> broken() {
        return Stream.of(
                argumentSet(
                        "number that is none becomes 0",
                        CUBE.replace("v 1 1 1", "v 1 NaN 1"),
                        MATERIALS,
                        "CUBE:8: 'v' needs a number in ±1e18 as number 2, got 'NaN'"),
                argumentSet(
                        "empty file is an empty picture",
                        "",
                        MATERIALS,
                        "CUBE: no face with an area, no line and no point is in it"));
    }

    @Test
    void missingModelIsNamed() {
        String file = folder.resolve("cube.obj").toString();
        render().assertComplains(2, "./lab render: " + file + ": no such file to read");
    }

    private void model(String model, String materials, int width, int height) throws Exception {
        Files.writeString(folder.resolve("cube.obj"), model);
        Files.writeString(folder.resolve("cube.mtl"), materials);
        Files.createDirectories(folder.resolve("textures"));
        var texture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++)
                texture.setRGB(x, y, (x + y) % 2 == 0 ? 0x80FF80 : 0x8080FF);
        ImageIO.write(texture, "png", folder.resolve("textures/grid.png").toFile());
    }

    private Ran render(String... options) {
        String[] fixed = {"render", folder.resolve("cube.obj").toString(), "--size", "160x120"};
        return Ran.lab(
                Stream.of(
                                Stream.of(fixed),
                                Stream.of("--out", folder.resolve("out.png").toString()),
                                Stream.of(options))
                        .flatMap(part -> part)
                        .toArray(String[]::new));
    }

    private BufferedImage picture(String... options) throws Exception {
        render(options).assertDone();
        return ImageIO.read(folder.resolve("out.png").toFile());
    }

    private static void assertSame(BufferedImage one, BufferedImage other) {
        assertArrayEquals(
                one.getRGB(0, 0, 160, 120, null, 0, 160),
                other.getRGB(0, 0, 160, 120, null, 0, 160));
    }
}
