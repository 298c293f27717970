package rasterlab.app.cli.render;

import static java.time.Duration.ofSeconds;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.Ran;
import rasterlab.engine.pipeline.Renderer;

/**
 * Scenes as none should be: each is drawn by every visibility method, or refused with the value.
 */
@Tag("slow")
class BadSceneTest {
    private static final Duration LONG = ofSeconds(300);
    private static final String SQUARE =
            """
            v -1 -1 0
            v 1 -1 0
            v 1 1 0
            v -1 1 0
            vt 0 0
            vt 1 0
            vt 1 1
            vt 0 1
            """;

    @TempDir Path folder;

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("refused")
    void isRefusedByEveryMethod(String file, String text, String value, String[] options)
            throws Exception {
        Files.writeString(folder.resolve(file), text);
        for (String visibility : Renderer.visibilities()) {
            Ran ran = render(file, visibility, options);
            assertEquals(2, ran.exitCode(), visibility + ": " + ran.err());
            assertTrue(ran.err().contains(value), visibility + ": " + ran.err());
            assertEquals(1, ran.err().lines().count(), visibility + ": " + ran.err());
        }
    }

    static Stream<Arguments> refused() {
        String good = SQUARE + "f 1 2 3 4\n";
        return Stream.of(
                refusal("empty mesh is drawn", "m.obj", SQUARE, "no face with an area"),
                refusal(
                        "zero-area face alone is drawn",
                        "m.obj",
                        SQUARE + "f 1 2 2\n",
                        "no face with an area"),
                refusal("index is out of range", "m.obj", SQUARE + "f 1 2 5\n", "vertex 5"),
                refusal("index 0 is taken", "m.obj", SQUARE + "f 0 1 2\n", "vertex 0"),
                refusal("NaN is a place", "m.obj", "v NaN 0 0\n" + good, "'NaN'"),
                refusal("infinity is a place", "m.obj", "v 0 1e999 0\n" + good, "'1e999'"),
                refusal(
                        "face of a scene file has no area",
                        "m.scene.json",
                        triangle("[0, 0, 0], [1, 1, 1], [2, 2, 2]"),
                        "span no area"),
                refusal(
                        "index of a scene file is out of range",
                        "m.scene.json",
                        triangle("[0, 0, 0], [1, 0, 0]"),
                        "from 0 to 1, got 2"),
                refusal(
                        "NaN is JSON",
                        "m.scene.json",
                        triangle("[NaN, 0, 0], [1, 0, 0], [0, 1, 0]"),
                        "NaN"),
                refusal(
                        "near is far",
                        "m.obj",
                        good,
                        "--near must be below --far 5, got 5",
                        "--up",
                        "y",
                        "--near",
                        "5",
                        "--far",
                        "5"),
                refusal(
                        "near is beyond far",
                        "m.obj",
                        good,
                        "--near must be below --far 5, got 6",
                        "--up",
                        "y",
                        "--near",
                        "6",
                        "--far",
                        "5"),
                refusal("near is NaN", "m.obj", good, "NaN", "--up", "y", "--near", "NaN"),
                refusal("picture has no pixel", "m.obj", good, "got 0×1", "--size", "0x1"),
                refusal("picture is too large", "m.obj", good, "got 8193×1", "--size", "8193x1"));
    }

    private static Arguments refusal(
            String mistake, String file, String text, String value, String... options) {
        return argumentSet(mistake, file, text, value, options);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("drawn")
    void isDrawnByEveryMethod(String file, String text, String[] options) throws Exception {
        Files.writeString(folder.resolve(file), text);
        Files.writeString(folder.resolve("one.mtl"), "newmtl one\nmap_Kd 1x1.png\n");
        Files.writeString(folder.resolve("odd.mtl"), "newmtl odd\nmap_Kd 3x5.png\n");
        texture(1, 1);
        texture(3, 5);
        for (String visibility : Renderer.visibilities()) {
            Ran ran =
                    assertTimeoutPreemptively(
                            LONG, () -> render(file, visibility, options), visibility);
            assertFalse(ran.err().contains("\tat "), visibility + ": " + ran.err());
            if (visibility.equals("convex")) assertIsNoClosedBody(ran);
            else assertEquals(0, ran.exitCode(), visibility + ": " + ran.err());
        }
    }

    private static void assertIsNoClosedBody(Ran ran) {
        assertEquals(3, ran.exitCode(), ran.err());
        assertTrue(ran.err().contains("convex refuses: the scene must be one convex closed body"));
    }

    static Stream<Arguments> drawn() {
        String good = SQUARE + "f 1 2 3 4\n";
        String faces = "f 1/1 2/2 3/3 4/4\n";
        List<Arguments> cases = new ArrayList<>();
        cases.add(drawing("picture of one pixel", "m.obj", good, "--size", "1x1"));
        cases.add(drawing("one row", "m.obj", good, "--size", "500x1"));
        cases.add(drawing("one column", "m.obj", good, "--size", "1x500"));
        cases.add(drawing("zero-area face among others", "m.obj", good + "f 1 2 2\n"));
        cases.add(
                drawing(
                        "texture of 1×1",
                        "m.obj",
                        "mtllib one.mtl\nusemtl one\n" + SQUARE + faces));
        cases.add(
                drawing(
                        "texture of 3×5",
                        "m.obj",
                        "mtllib odd.mtl\nusemtl odd\n" + SQUARE + faces));
        cases.add(
                drawing(
                        "eye in the plane of a face and inside it",
                        "m.scene.json",
                        triangle("[500, -90, -90], [500, 90, -90], [500, 0, 90]"),
                        "--camera",
                        "0,0.5pi,500"));
        cases.add(
                drawing(
                        "eye on the edge of a face that lies along the sight",
                        "m.scene.json",
                        triangle("[900, 0, -90], [100, 0, -90], [500, 0, 90]"),
                        "--camera",
                        "0,0.5pi,500"));
        cases.add(
                drawing(
                        "face on the near plane",
                        "m.obj",
                        good,
                        "--near",
                        "500",
                        "--camera",
                        "0,0,500"));
        if (Boolean.getBoolean("rasterlab.full"))
            cases.add(drawing("largest picture", "m.obj", good, "--size", "8192x8192"));
        return cases.stream();
    }

    private static Arguments drawing(String what, String file, String text, String... options) {
        return argumentSet(what + " crashes a method", file, text, options);
    }

    private static String triangle(String vertices) {
        return """
        {"version": 1, "scene": {"name": "one", "vertices": [%s],
          "faces": [{"corners": [0, 1, 2], "finish": 0}], "finishes": [{"diffuse": [1, 1, 1]}],
          "light": {"ambient": [0.2, 0.2, 0.2], "localViewer": true, "twoSided": true,
            "reflection": "phong", "lights": []},
          "background": 255, "pictureScale": 1}}
        """
                .formatted(vertices);
    }

    private void texture(int width, int height) throws Exception {
        var picture = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        picture.setRGB(width - 1, height - 1, 0xFF8040);
        ImageIO.write(
                picture, "png", folder.resolve("%dx%d.png".formatted(width, height)).toFile());
    }

    private Ran render(String file, String visibility, String... options) {
        List<String> all =
                new ArrayList<>(
                        List.of(
                                "render",
                                folder.resolve(file).toString(),
                                "--visibility",
                                visibility,
                                "--out",
                                folder.resolve("out.png").toString()));
        if (!List.of(options).contains("--size")) all.addAll(List.of("--size", "120x90"));
        all.addAll(List.of(options));
        return Ran.lab(all.toArray(String[]::new));
    }
}
