package rasterlab.tests.bench.grader;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class BelongingsTest {
    private final List<String> ended = new ArrayList<>();

    @Test
    @DisplayName("a disk is unmounted before the server on it has ended")
    void endsTheLastFirstAndEachOnce() throws IOException {
        var all = new Belongings();
        all.add(() -> () -> ended.add("disk"));
        all.add(() -> () -> ended.add("server"));
        all.close();
        all.close();
        assertEquals(List.of("server", "disk"), ended);
    }

    @Test
    @DisplayName("what cannot be ended keeps the rest running")
    void goesOnAfterOneThatFails() throws IOException {
        var all = new Belongings();
        all.add(() -> () -> ended.add("disk"));
        all.add(
                () ->
                        () -> {
                            throw new IOException("does not end");
                        });
        var told = assertThrows(IllegalStateException.class, all::close);
        assertEquals("does not end", told.getSuppressed()[0].getMessage());
        assertEquals(List.of("disk"), ended);
    }

    @Test
    @DisplayName("something is started after all has ended, and stays")
    void startsNothingAfterTheEnd() {
        var all = new Belongings();
        all.close();
        assertThrows(
                IllegalStateException.class,
                () ->
                        all.add(
                                () -> {
                                    ended.add("started");
                                    return () -> ended.add("ended");
                                }));
        assertEquals(List.of(), ended);
    }
}
