package rasterlab.app.language;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;

class ComplaintsTest {
    /** What no file says; all patterns are tried. */
    private static final String UNKNOWN = "a sentence of the operating system";

    /** Bytes; compiling all patterns takes twice as many. */
    private static final long MOST = 400_000;

    @Test
    void patternsAreNotCompiledForEverySentence() {
        var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        assertEquals(UNKNOWN, Complaints.said(Language.RUSSIAN, UNKNOWN));
        long before = threads.getCurrentThreadAllocatedBytes();
        Complaints.said(Language.RUSSIAN, UNKNOWN);
        long taken = threads.getCurrentThreadAllocatedBytes() - before;
        assertTrue(taken < MOST, taken + " bytes");
    }
}
