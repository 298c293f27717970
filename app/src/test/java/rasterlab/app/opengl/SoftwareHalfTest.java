package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.Lab;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.Setting;
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
        "--set scene=quad --set lights=2 --set scene=globe, 'scene twice, ''quad'' and ''globe'''",
        "--set lights=2 --set lights=2, 'lights twice, ''2'' and ''2'''",
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

    @Test
    @DisplayName("an image is passed over where --set does not ask for it")
    void imageIsTheTexture() throws IOException {
        Path image = Files.write(folder.resolve("one image.png"), striped());
        byte[] expected = drawn("--set image=file --set texture-2d=on --image", image);
        assertArrayEquals(expected, drawn("--image", image));
        byte[] bare = drawn("--set texture-2d=off --image", image);
        assertFalse(Arrays.equals(expected, bare), "the image is not seen");
        assertArrayEquals(bare, drawn("--set image=file --image", image));
        String complaint =
                lab("./lab opengl --set image=map --image a.png --out " + folder.resolve("y.png"));
        assertTrue(complaint.contains("--image is the texture of image=file"), complaint);
    }

    private byte[] drawn(String options, Path image) throws IOException {
        Path out = folder.resolve("x.png");
        List<String> words = words("./lab opengl --set scene=quad --size 80x60 " + options);
        words.addAll(List.of(image.toString(), "--out", out.toString()));
        assertEquals("", lab(words));
        return Files.readAllBytes(out);
    }

    private static byte[] striped() throws IOException {
        var bytes = new ByteArrayOutputStream();
        var image = new BufferedImage(4, 4, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 16; i++) image.setRGB(i % 4, i / 4, i * 0x0F0301);
        ImageIO.write(image, "png", bytes);
        return bytes.toByteArray();
    }

    @Test
    @DisplayName("the copied command finds an image of the user in its own folder only")
    void commandNamesTheImageWhereverItIsRun() throws IOException {
        Path image = Files.write(folder.resolve("image.png"), striped());
        Path fromHere = Path.of("").toAbsolutePath().relativize(image);
        for (Path given : List.of(image, fromHere)) {
            GlChoice choice =
                    GlChoice.first()
                            .with(Setting.SCENE, "quad")
                            .withFile(SoftwareHalf.image(given));
            String command = SoftwareHalf.command(choice, WIDTH, HEIGHT);
            String named = command.replaceFirst(".* --image (\\S+) .*", "$1");
            assertTrue(Path.of(named).isAbsolute(), command);
            Path out = folder.resolve("drawn.png");
            assertEquals("", lab(command.replaceFirst("--out .*", "--out " + out)), command);
            Raster shown = SoftwareHalf.of(choice, WIDTH, HEIGHT);
            int[] drawn = ImageIO.read(out.toFile()).getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH);
            assertArrayEquals(shown.argb(), drawn, command);
        }
    }

    @ParameterizedTest(name = "what OpenGL leaves open is drawn without a word: components={0}")
    @CsvSource({"1, true", "2, true", "3, false", "4, false"})
    void tellsWhatOpenGlLeavesOpen(String components, boolean open) {
        CommandAnswer said =
                answer(
                        words(
                                "./lab opengl --set scene=globe --set texture-2d=on --set"
                                        + " env-mode=GL_DECAL --size 8x6 --set components="
                                        + components
                                        + " --out "
                                        + folder.resolve("x.png")));
        assertEquals(0, said.exit(), said.err());
        assertEquals(
                open,
                said.err().contains("note: OpenGL leaves open what GL_DECAL does"),
                said.err());
    }

    @Test
    void helpListsEverySettingAndOption() {
        String help = answer(words("./lab help opengl")).out();
        String joined = help.replaceAll("\n {9,}", " ");
        for (Setting setting : Setting.values()) {
            String row = "\n  " + setting.code() + " ";
            int at = joined.indexOf(row);
            assertTrue(at >= 0, setting.code());
            String options = joined.substring(at + row.length()).lines().findFirst().orElseThrow();
            assertEquals(setting.options(), List.of(options.strip().split(", ")), row);
        }
        assertTrue(help.lines().allMatch(line -> line.length() <= 100), help);
        assertTrue(help.contains("\nExample: "), help);
    }

    @ParameterizedTest(name = "the complaint does not tell what is wrong: {0}")
    @CsvSource({
        "folder, 'is a folder, not a picture'",
        "text, is not a picture that can be read",
        "cut, the picture is cut off",
        "wide, has 9000×1 pixels"
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

    private record CommandAnswer(int exit, String out, String err) {}

    /** The complaint; "" where there is none. */
    private static String lab(String command) {
        return lab(words(command));
    }

    private static String lab(List<String> words) {
        CommandAnswer said = answer(words);
        return said.exit() == 0 ? "" : said.err();
    }

    private static List<String> words(String command) {
        return new ArrayList<>(List.of(command.substring("./lab ".length()).split(" ")));
    }

    private static CommandAnswer answer(List<String> words) {
        var out = new ByteArrayOutputStream();
        var err = new ByteArrayOutputStream();
        int exit =
                Lab.run(
                        words.toArray(String[]::new),
                        new ByteArrayInputStream(new byte[0]),
                        new PrintStream(out, true, StandardCharsets.UTF_8),
                        new PrintStream(err, true, StandardCharsets.UTF_8));
        return new CommandAnswer(
                exit, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
    }
}
