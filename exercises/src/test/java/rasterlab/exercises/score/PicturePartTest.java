package rasterlab.exercises.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.exercises.drawing.PixelPictures;

class PicturePartTest {
    @Test
    @DisplayName("a cut picture is not called a part of one, or only in English")
    void aCutPictureTellsItsPlace() {
        CasePicture picture = line(1001, 500);
        PicturePart part = picture.part().orElseThrow();
        assertFalse(part.isWhole());
        assertEquals("columns 460..539 of 0..1000, rows 0..0 of 0..0", part.message().in("en"));
        assertEquals("столбцы 460..539 из 0..1000, строки 0..0 из 0..0", part.message().in("ru"));
        assertEquals(
                part.message().in("en"), picture.text().in("ru").lines().findFirst().orElseThrow());
        assertEquals(List.of("#".repeat(80)), rows(picture));
    }

    @Test
    @DisplayName("a whole picture is called a part")
    void aWholePictureIsNone() {
        assertTrue(line(80, 0).part().orElseThrow().isWhole());
        assertEquals(List.of("#".repeat(80)), rows(line(80, 0)));
    }

    @Test
    @DisplayName("a part that is kept is another one when it is read")
    void aPartIsReadAsItWasWritten() {
        Optional<PicturePart> part = line(1001, 500).part();
        assertEquals(part, PicturePart.ofData(part.orElseThrow().data()));
        assertEquals(
                "{\"shown\":{\"xmin\":460,\"ymin\":0,\"xmax\":539,\"ymax\":0},"
                        + "\"whole\":{\"xmin\":0,\"ymin\":0,\"xmax\":1000,\"ymax\":0},"
                        + "\"pixel\":{\"x\":500,\"y\":0}}",
                part.orElseThrow().data());
    }

    @ParameterizedTest(name = "what is no part is read as one, or ends in an error: {0}")
    @ValueSource(
            strings = {
                "",
                "null",
                "[]",
                "{}",
                "{\"shown\":{\"xmin\":9,\"ymin\":0,\"xmax\":0,\"ymax\":0},"
                        + "\"whole\":{\"xmin\":0,\"ymin\":0,\"xmax\":9,\"ymax\":0},"
                        + "\"pixel\":{\"x\":0,\"y\":0}}"
            })
    void whatIsNoPartIsNone(String data) {
        assertEquals(Optional.empty(), PicturePart.ofData(data));
    }

    private static List<String> rows(CasePicture picture) {
        return PixelRows.of(picture.text().in("en"), picture.part());
    }

    private static CasePicture line(int pixels, int around) {
        PixelRecording drawn = new PixelRecording(pixels);
        for (int x = 0; x < pixels; x++) drawn.plot(x, 0);
        PixelDifference same = PixelDifference.of(drawn, drawn);
        List<CasePicture> all = PixelPictures.of(same, PixelSet.EMPTY, new Pixel(around, 0));
        return CasePicture.of(all, CasePicture.DIFFERENCE).orElseThrow();
    }
}
