package rasterlab.engine.raster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.study.LimitReached;

class PixelRecordingTest {
    @ParameterizedTest
    @ValueSource(ints = {1, 63, 64, 65, 1_000})
    void keepsEveryWriteUpToTheLimitAndNoMore(int limit) {
        var recording = new PixelRecording(limit);
        for (int i = 0; i < limit; i++) recording.plot(i, -i);
        var reached = assertThrows(LimitReached.class, () -> recording.plot(7, 7));
        assertSame(recording, reached.recorded());
        assertEquals(limit, recording.size());
        assertEquals(limit - 1, recording.x(limit - 1));
        assertEquals(1 - limit, recording.y(limit - 1));
    }

    @Test
    void keepsRepetitions() {
        var recording = new PixelRecording(5);
        recording.plot(1, 2);
        recording.plot(1, 2);
        assertEquals(2, recording.size());
    }

    @Test
    void refusesAnIndexBeyondItsWrites() {
        var recording = new PixelRecording(5);
        recording.plot(1, 2);
        assertThrows(IndexOutOfBoundsException.class, () -> recording.x(1));
        assertThrows(IndexOutOfBoundsException.class, () -> recording.y(-1));
    }

    @Test
    void refusesALimitBelowOne() {
        assertThrows(IllegalArgumentException.class, () -> new PixelRecording(0));
    }
}
