package rasterlab.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

class WatchedOutputTest {
    @Test
    void aFullDiskIsToldThoughThePrintStreamAboveIsSilent() {
        assertEquals(
                Optional.of("No space left on device"), lossOf("No space left on device", "text"));
    }

    @Test
    void aReaderWhoHasSeenEnoughIsNoLoss() {
        assertEquals(Optional.empty(), lossOf("Broken pipe", "text"));
    }

    @Test
    void whatIsWrittenIsNoLoss() {
        assertEquals(Optional.empty(), lossOf("No space left on device", ""));
    }

    @Test
    void theFirstReasonIsToldThoughLaterOnesFollow() {
        var reasons = new ArrayDeque<>(List.of("No space left on device", "Broken pipe"));
        var watched = new WatchedOutput(failing(reasons::remove));
        assertThrows(IOException.class, () -> watched.write('a'));
        assertThrows(IOException.class, () -> watched.write(new byte[1]));
        assertEquals(Optional.of("No space left on device"), watched.loss());
    }

    private static OutputStream failing(Supplier<String> reason) {
        return new OutputStream() {
            @Override
            public void write(int value) throws IOException {
                throw new IOException(reason.get());
            }
        };
    }

    private static Optional<String> lossOf(String failure, String text) {
        var watched = new WatchedOutput(failing(() -> failure));
        var print = new PrintStream(watched);
        print.print(text);
        print.flush();
        return watched.loss();
    }
}
