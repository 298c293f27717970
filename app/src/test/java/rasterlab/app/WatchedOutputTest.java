package rasterlab.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.util.Optional;
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

    private static Optional<String> lossOf(String failure, String text) {
        var watched =
                new WatchedOutput(
                        new OutputStream() {
                            @Override
                            public void write(int value) throws IOException {
                                throw new IOException(failure);
                            }
                        });
        var print = new PrintStream(watched);
        print.print(text);
        print.flush();
        return watched.loss();
    }
}
