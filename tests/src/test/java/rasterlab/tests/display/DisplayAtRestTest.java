package rasterlab.tests.display;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JFrame;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

@Tag("slow")
@ExtendWith(OwnDisplay.class)
class DisplayAtRestTest {
    private static final int WINDOWS = 20;

    /** Window after window, for one alone may be painted before anyone waits. */
    @Test
    void whatTheDisplayHadToSayHasBeenHandled() throws Exception {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        for (int k = 0; k < WINDOWS; k++) {
            var painted = new AtomicBoolean();
            var frame = new JFrame[1];
            EventQueue.invokeAndWait(
                    () -> {
                        frame[0] =
                                new JFrame() {
                                    private static final long serialVersionUID = 1L;

                                    @Override
                                    public void paint(java.awt.Graphics g) {
                                        painted.set(true);
                                    }
                                };
                        frame[0].setSize(100, 100);
                        frame[0].setVisible(true);
                    });
            DisplayAtRest.await();
            assertTrue(painted.get(), "the server's word that window " + k + " is in sight");
            EventQueue.invokeAndWait(frame[0]::dispose);
        }
    }
}
