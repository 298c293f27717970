package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.Lab;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.engine.raster.Raster;

class SoftwareHalfTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 72;

    @TempDir Path folder;

    @ParameterizedTest(name = "the command draws another picture than the tab: {0}")
    @EnumSource(GlView.class)
    void commandDrawsThePictureOfTheTab(GlView view) throws IOException {
        GlChoice choice = view.choice();
        String command = SoftwareHalf.command(choice, WIDTH, HEIGHT);
        Path out = folder.resolve("drawn.png");
        assertEquals("", lab(command.replaceFirst("--out .*", "--out " + out)), command);
        Raster shown = SoftwareHalf.of(choice, WIDTH, HEIGHT);
        int[] drawn = ImageIO.read(out.toFile()).getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH);
        assertArrayEquals(shown.argb(), drawn, command);
    }

    @ParameterizedTest(name = "{0} is taken")
    @CsvSource({
        "--set shade-model, SETTING=OPTION",
        "--set shade=GL_FLAT, no setting 'shade'; there are scene",
        "--set shade-model=GL_ROUND, GL_SMOOTH",
        "--set image=file, needs a file",
        "--image gone.png, gone.png: no such file to read",
        "--tilt 91, from −90 to 90",
        "--turn 360, must be in",
        "--distance 2, from 3.8"
    })
    void refusesWhatTheTabHasNot(String option, String part) {
        String complaint = lab("./lab opengl " + option + " --out " + folder.resolve("x.png"));
        assertTrue(complaint.contains(part), complaint);
        assertEquals(1, complaint.lines().count(), complaint);
    }

    @ParameterizedTest(name = "lines shorter than a pixel leave the range of colours: {0}")
    @ValueSource(
            strings = {
                "--size 1x1",
                "--size 7x3",
                "--size 800x1",
                "--size 1x600",
                "--set scene=globe --set polygon-mode=GL_LINE --distance 16 --size 100x75",
                "--set scene=globe --set polygon-mode=GL_LINE --distance 16 --turn 40 --tilt 0"
                        + " --size 200x150"
            })
    void drawsEverySize(String options) {
        assertEquals("", lab("./lab opengl " + options + " --out " + folder.resolve("x.png")));
    }

    @ParameterizedTest(name = "the complaint does not tell what is wrong: {0}")
    @CsvSource({
        "folder, cannot be read",
        "text, 'is no PNG, JPEG, GIF or BMP image'",
        "cut, is a broken image",
        "wide, has 9000 × 1 pixels"
    })
    void tellsWhatIsWrongWithAnImage(String kind, String part) throws IOException {
        Path file = folder.resolve(kind);
        if (kind.equals("folder")) Files.createDirectory(file);
        if (kind.equals("text")) Files.writeString(file, "no image");
        if (kind.equals("cut")) Files.write(file, Arrays.copyOf(png(9, 9), 40));
        if (kind.equals("wide")) Files.write(file, png(9000, 1));
        String complaint =
                lab("./lab opengl --image " + file + " --out " + folder.resolve("x.png"));
        assertTrue(complaint.contains(file + ": " + part), complaint);
    }

    private static byte[] png(int width, int height) throws IOException {
        var bytes = new ByteArrayOutputStream();
        ImageIO.write(new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB), "png", bytes);
        return bytes.toByteArray();
    }

    @Test
    void writesPngOnly() {
        String complaint = lab("./lab opengl --out " + folder.resolve("x.gif"));
        assertTrue(complaint.contains("allowed is .png"), complaint);
    }

    /** What it complains of; "" where it is done. */
    private static String lab(String command) {
        var err = new ByteArrayOutputStream();
        int exit =
                Lab.run(
                        command.substring("./lab ".length()).split(" "),
                        new ByteArrayInputStream(new byte[0]),
                        new PrintStream(new ByteArrayOutputStream()),
                        new PrintStream(err, true, StandardCharsets.UTF_8));
        return exit == 0 ? "" : err.toString(StandardCharsets.UTF_8);
    }
}
