package rasterlab.exercises.runner.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** Limits hold where the kernel says so. */
class LimitCheckTest {
    @Test
    @DisplayName("a limit is believed because it was asked for")
    void aLimitIsReadFromTheKernel() {
        var kernels =
                List.of(
                        "Limit                     Soft Limit           Hard Limit           Units",
                        "Max cpu time              30                   30                   seconds",
                        "Max file size             0                    0                    bytes",
                        "Max core file size        0                    0                    bytes",
                        "Max processes             4096                 4096                 processes",
                        "Max open files            256                  256                  files");
        assertEquals(Optional.empty(), LimitCheck.fault(kernels, true));
        for (int i = 1; i < kernels.size(); i++) {
            var loose = new ArrayList<>(kernels);
            loose.set(i, loose.get(i).replaceFirst("(\\d+ +)\\d+ ", "$1unlimited "));
            assertTrue(LimitCheck.fault(loose, true).isPresent(), loose.get(i));
            loose.remove(i);
            assertTrue(LimitCheck.fault(loose, true).isPresent(), kernels.get(i) + " is missing");
        }
    }
}
