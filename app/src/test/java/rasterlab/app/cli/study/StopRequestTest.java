package rasterlab.app.cli.study;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class StopRequestTest {
    @Test
    void theProgramEndsOnlyOnceTheCommandHas() throws Exception {
        var stop = new StopRequest();
        assertFalse(stop.isMade());
        var ending = new Thread(stop::make);
        ending.start();
        while (ending.isAlive() && ending.getState() != Thread.State.TIMED_WAITING)
            Thread.onSpinWait();
        assertTrue(stop.isMade());
        assertTrue(ending.isAlive(), "it waits for the command");
        stop.close();
        ending.join();
    }
}
