package rasterlab.exercises.runner.process;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** An account is judged by what the kernel lets it do. */
class SystemAccountTest {
    @ParameterizedTest(name = "who has {0} is held by a limit on processes")
    @ValueSource(
            strings = {
                "Uid:\t0\t0\t0\t0",
                "Uid:\t1000\t0\t0\t0",
                "CapEff:\t0000000001000000",
                "CapEff:\t0000000000200000"
            })
    void rootIsKnownByItsRightsNotByItsName(String status) {
        assertTrue(SystemAccount.exceedsLimits(List.of("Name:\tjava", status)));
        assertFalse(
                SystemAccount.exceedsLimits(
                        List.of("Uid:\t1000\t1000\t1000\t1000", "CapEff:\t0000000000000000")));
    }
}
