package rasterlab.app.outcome;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.texture.Texture;

class PictureFileTest {
    private static final String ALLOWED = "; allowed are whole pictures as PNG, JPEG, GIF or BMP";
    private static final String CUT = ": the picture is cut off: the file ends too early" + ALLOWED;

    @TempDir Path folder;

    private Path written(String format, int type, int width, int height) throws Exception {
        var image = new BufferedImage(width, height, type);
        image.setRGB(0, 0, 0xFFC06030);
        Path file = folder.resolve("picture." + format);
        ImageIO.write(image, format, file.toFile());
        return file;
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("pictures")
    void readsPictures(String format, int type, int width, int height, int components)
            throws Exception {
        Texture texture = PictureFile.texture(written(format, type, width, height));
        assertEquals(width, texture.width());
        assertEquals(height, texture.height());
        assertEquals(components, texture.components());
        int topLeft = texture.level(0).texel(0, height - 1);
        assertEquals(0xC0, topLeft >> 16 & 255, 6, "the first row is the top one");
    }

    static Stream<Arguments> pictures() {
        int rgb = BufferedImage.TYPE_INT_RGB;
        return Stream.of(
                argumentSet("one pixel is refused", "png", rgb, 1, 1, 3),
                argumentSet("picture stands on its head", "png", rgb, 3, 5, 3),
                argumentSet("alpha is lost", "png", BufferedImage.TYPE_INT_ARGB, 3, 5, 4),
                argumentSet("JPEG is refused", "jpg", rgb, 1, 1, 3),
                argumentSet("widest picture is refused", "png", rgb, 8192, 1, 3));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("grays")
    void grayLevelsAreThoseOfTheFile(String format, int bits, boolean alpha, int components)
            throws Exception {
        var model =
                new ComponentColorModel(
                        ColorSpace.getInstance(ColorSpace.CS_GRAY),
                        alpha,
                        false,
                        alpha ? Transparency.TRANSLUCENT : Transparency.OPAQUE,
                        bits == 8 ? DataBuffer.TYPE_BYTE : DataBuffer.TYPE_USHORT);
        WritableRaster levels = model.createCompatibleWritableRaster(8, 8);
        int middle = bits == 8 ? 128 : 128 * 257;
        for (int k = 0; k < 64 * levels.getNumBands(); k++)
            levels.setSample(k % 8, k / 8 % 8, k / 64, k < 64 ? middle : middle / 2);
        Path file = folder.resolve("grey." + format);
        ImageIO.write(new BufferedImage(model, levels, false, null), format, file.toFile());
        Texture texture = PictureFile.texture(file);
        assertEquals(components, texture.components());
        int texel = texture.level(0).texel(3, 3);
        assertEquals(0x808080, texel & 0xFFFFFF, () -> Integer.toHexString(texel));
        assertEquals(alpha ? 64 : 255, texel >>> 24);
    }

    static Stream<Arguments> grays() {
        return Stream.of(
                argumentSet("grey PNG becomes lighter", "png", 8, false, 1),
                argumentSet("grey JPEG becomes lighter", "jpg", 8, false, 1),
                argumentSet("grey with alpha becomes lighter", "png", 8, true, 2),
                argumentSet("deep grey becomes lighter", "png", 16, false, 1),
                argumentSet("deep grey with alpha becomes lighter", "png", 16, true, 2));
    }

    @Test
    @DisplayName("too large or broken pictures are read")
    void refuses() throws Exception {
        Path wide = written("png", BufferedImage.TYPE_BYTE_BINARY, 8193, 1);
        assertMessage(wide, wide + ": has 8193×1 pixels; a texture has from 1×1 to 8192×8192");
        Path part = folder.resolve("part.png");
        byte[] whole = Files.readAllBytes(written("png", BufferedImage.TYPE_INT_RGB, 9, 9));
        Files.write(part, Arrays.copyOf(whole, 40));
        assertMessage(part, part + CUT);
        assertMessage(folder, folder + ": is a folder, not a picture");
        Path empty = Files.createFile(folder.resolve("empty.png"));
        assertMessage(empty, empty + ": the file is empty" + ALLOWED);
    }

    @Test
    @DisplayName("what is missing of a JPEG becomes grey")
    void refusesPartOfAJpeg() throws Exception {
        Path part = folder.resolve("part.jpg");
        byte[] whole = Files.readAllBytes(written("jpg", BufferedImage.TYPE_INT_RGB, 400, 300));
        Files.write(part, Arrays.copyOf(whole, whole.length - 300));
        assertMessage(part, part + CUT);
    }

    @ParameterizedTest(name = "a cut-off picture is told in Java''s words: {0}, {1} % of it")
    @CsvSource({
        "png, 30", "png, 70", "png, 98", "jpg, 5", "jpg, 30", "jpg, 70", "jpg, 98", "gif, 30",
        "gif, 70", "gif, 98", "bmp, 5", "bmp, 30", "bmp, 70", "bmp, 98"
    })
    void refusesWhatIsCutOff(String format, int percent) throws Exception {
        Path whole = noisy(format);
        byte[] bytes = Files.readAllBytes(whole);
        PictureFile.texture(whole);
        Path part = folder.resolve("part");
        Files.write(part, Arrays.copyOf(bytes, bytes.length * percent / 100));
        assertMessage(part, part + CUT);
    }

    private Path noisy(String format) throws Exception {
        var image = new BufferedImage(60, 50, BufferedImage.TYPE_INT_RGB);
        var random = new Random(1);
        for (int k = 0; k < 60 * 50; k++) image.setRGB(k % 60, k / 60, random.nextInt(1 << 24));
        Path file = folder.resolve("noisy." + format);
        assertTrue(ImageIO.write(image, format, file.toFile()), "no writer");
        return file;
    }

    @Test
    @DisplayName("a damaged picture is told in Java's words")
    void refusesWhatIsDamaged() throws Exception {
        byte[] bytes = Files.readAllBytes(noisy("png"));
        for (int k = 200; k < 260; k++) bytes[k] ^= 0x55;
        Path damaged = Files.write(folder.resolve("damaged.png"), bytes);
        assertMessage(damaged, damaged + ": the picture is damaged" + ALLOWED);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("ends")
    void tellsCutOffFromDamaged(String expected, String format, String bytesAtTheEnd)
            throws Exception {
        byte[] whole = Files.readAllBytes(noisy(format));
        var picture = new ByteArrayOutputStream();
        picture.write(whole, 0, whole.length - (expected.equals(PictureFault.CUT) ? 300 : 0));
        picture.writeBytes(bytesAtTheEnd.getBytes(StandardCharsets.ISO_8859_1));
        Path file = Files.write(folder.resolve("ends"), picture.toByteArray());
        assertEquals(expected, PictureFault.of(file, new IOException("unreadable")));
    }

    static Stream<Arguments> ends() {
        String cut = PictureFault.CUT;
        String damaged = PictureFault.DAMAGED;
        return Stream.of(
                argumentSet("a semicolon near a GIF's end passes for it", cut, "gif", ";12"),
                argumentSet("zeros behind a GIF make it cut off", damaged, "gif", "\0".repeat(100)),
                argumentSet("text behind a JPEG makes it cut off", damaged, "jpg", "x".repeat(100)),
                argumentSet(
                        "a JPEG's small picture ends the large one",
                        cut,
                        "jpg",
                        "\u00FF\u00D9\u00FF\u00DAcut off"));
    }

    @Test
    @DisplayName("a file that begins as some rare kind of picture is read as one")
    void refusesOtherKinds() throws Exception {
        Path wbmp = Files.write(folder.resolve("two"), new byte[] {0, 0, 2, 2, 0, 0});
        assertMessage(wbmp, wbmp + ": is not a picture that can be read" + ALLOWED);
    }

    private static void assertMessage(Path file, String message) {
        assertEquals(
                message,
                assertThrows(Complaint.class, () -> PictureFile.texture(file)).getMessage());
    }
}
