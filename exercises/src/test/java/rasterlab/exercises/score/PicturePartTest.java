package rasterlab.exercises.score;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;

class PicturePartTest {
    @Test
    @DisplayName("a cut picture is not called a part of one, or only in English")
    void aCutPictureTellsItsPlace() {
        PicturePart part = PicturePart.of(line(1001)).orElseThrow();
        assertEquals(1001, part.width());
        assertEquals(1, part.height());
        assertEquals("columns 0..79 of 0..1000, rows 0..0 of 0..0", part.said().in("en"));
        assertEquals("столбцы 0..79 из 0..1000, строки 0..0 из 0..0", part.said().in("ru"));
        assertEquals(List.of("#".repeat(80)), PicturePart.rows(line(1001)));
    }

    @Test
    @DisplayName("a whole picture is called a part")
    void aWholePictureIsNone() {
        assertEquals(true, PicturePart.of(line(80)).isEmpty());
        assertEquals(List.of("#".repeat(80)), PicturePart.rows(line(80)));
    }

    private static String line(int pixels) {
        PixelRecording drawn = new PixelRecording(pixels);
        for (int x = 0; x < pixels; x++) drawn.plot(x, 0);
        return PixelDifference.of(drawn, drawn).text(PixelSet.EMPTY);
    }
}
