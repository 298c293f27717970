package rasterlab.exercises.drawing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.PixelRows;

class PixelPicturesTest {
    @Test
    void picturesTellMissingAndExtraByShape() throws IOException {
        BufferedImage missing = picture(pictures("-"));
        BufferedImage extra = picture(pictures("+"));
        assertEquals(33, missing.getWidth());
        assertEquals(PixelMark.ARGB, extra.getRGB(16, 16), "the cross has the colour of each lab");
        assertNotEquals(missing.getRGB(16, 16), extra.getRGB(16, 16), "ring is open, cross is not");
        assertNotEquals(missing.getRGB(16, 7), missing.getRGB(16, 16));
    }

    @Test
    void aRightPixelThatIsDrawnAgainIsCrossedOut() throws IOException {
        PixelRecording again = new PixelRecording(1);
        again.plot(1, 0);
        List<CasePicture> pictures =
                PixelPictures.of(difference("###"), PixelSet.of(again), new Pixel(1, 0));
        BufferedImage picture = picture(pictures);
        assertEquals(PixelMark.ARGB, picture.getRGB(32 + 16, 16));
        assertNotEquals(PixelMark.ARGB, picture.getRGB(16, 16), "drawn once");
        assertEquals(List.of("#*#"), rows(of(pictures, CasePicture.DIFFERENCE)));
        assertEquals(List.of("###"), rows(of(pictures, CasePicture.ACTUAL)));
    }

    private static List<String> rows(CasePicture picture) {
        return PixelRows.of(picture.text().in("en"), picture.part());
    }

    private static BufferedImage picture(List<CasePicture> pictures) throws IOException {
        return ImageIO.read(new ByteArrayInputStream(of(pictures, CasePicture.DIFFERENCE).png()));
    }

    /** The pictures around the last pixel. */
    private static List<CasePicture> pictures(String row) {
        return PixelPictures.of(difference(row), PixelSet.EMPTY, new Pixel(row.length() - 1, 0));
    }

    /** One row of # right, + extra and - missing pixels. */
    private static PixelDifference difference(String row) {
        PixelRecording exact = new PixelRecording(99);
        PixelRecording actual = new PixelRecording(99);
        for (int x = 0; x < row.length(); x++) {
            if ("#-".indexOf(row.charAt(x)) >= 0) exact.plot(x, 0);
            if ("#+".indexOf(row.charAt(x)) >= 0) actual.plot(x, 0);
        }
        return PixelDifference.of(exact, actual);
    }

    @Test
    void expectedAndActualLeaveOutWhatTheOtherHas() {
        List<CasePicture> both = pictures("#+-#");
        List<CasePicture> exact = pictures("#.##");
        List<CasePicture> drawn = pictures("##.#");
        assertArrayEquals(
                of(exact, CasePicture.DIFFERENCE).png(), of(both, CasePicture.EXPECTED).png());
        assertArrayEquals(
                of(drawn, CasePicture.DIFFERENCE).png(), of(both, CasePicture.ACTUAL).png());
    }

    @Test
    void theBeginningOfALongPictureIsTheOneThatTheTextShows() throws IOException {
        List<CasePicture> pictures = pictures("#".repeat(90) + "-");
        BufferedImage picture = picture(pictures);
        assertEquals(80 * 8 + 1, picture.getWidth());
        String text = of(pictures, CasePicture.DIFFERENCE).text().in("en");
        assertTrue(text.endsWith("#-"), text);
        assertNotEquals(picture.getRGB(4, 4), picture.getRGB(79 * 8 + 4, 4), "the last is missing");
    }

    @ParameterizedTest(name = "the texts are not those of the three pictures: {0}")
    @ValueSource(strings = {"en", "ru"})
    void eachPictureHasRowsOfItsOwn(String language) {
        List<CasePicture> pictures = pictures("#+.-#");
        assertEquals(
                List.of("expected #..##", "actual ##..#", "difference #+.-#"),
                pictures.stream().map(one -> one.kind() + " " + one.text().in(language)).toList());
    }

    @Test
    void eachTextOfAPartBeginsWithItsPlace() {
        List<CasePicture> pictures = pictures("-+" + "#".repeat(90) + "+-");
        String place = "columns 14..93 of 0..93, rows 0..0 of 0..0\n" + "#".repeat(78);
        assertEquals(
                List.of(place + ".#", place + "#.", place + "+-"),
                pictures.stream().map(one -> one.text().in("en")).toList());
        assertEquals(List.of("#".repeat(78) + ".#"), rows(pictures.get(0)));
    }

    @Test
    void theRowsOfALargePictureAreWhole() {
        PixelRecording pixels = new PixelRecording(80 * 40);
        for (int y = 0; y < 40; y++) for (int x = 0; x < 80; x++) pixels.plot(x, y);
        PixelDifference same = PixelDifference.of(pixels, pixels);
        String row = "#".repeat(80);
        for (CasePicture one : PixelPictures.of(same, PixelSet.EMPTY, new Pixel(0, 0)))
            assertEquals((row + "\n").repeat(39) + row, one.text().in("ru"), one.kind());
    }

    private static CasePicture of(List<CasePicture> pictures, String kind) {
        return CasePicture.of(pictures, kind).orElseThrow();
    }
}
