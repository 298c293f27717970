package rasterlab.app.shell;

import java.awt.EventQueue;
import java.util.function.Consumer;

/**
 * Brings failures of any thread to the user, one at a time.
 *
 * <p>While one is shown, those like it are dropped, so that a failing repaint does not bury the
 * window under dialogs; every failure is also printed on the standard error stream.
 */
final class FailureReports implements Consumer<Throwable>, Thread.UncaughtExceptionHandler {
    private final Consumer<Throwable> show;
    private boolean showing;

    /**
     * @param show shows one failure and returns when the user has closed it; on the event thread
     */
    FailureReports(Consumer<Throwable> show) {
        this.show = show;
    }

    @Override
    public void accept(Throwable failure) {
        failure.printStackTrace();
        EventQueue.invokeLater(() -> showOne(failure));
    }

    @Override
    public void uncaughtException(Thread thread, Throwable failure) {
        accept(failure);
    }

    private void showOne(Throwable failure) {
        if (showing) return;
        showing = true;
        try {
            show.accept(failure);
        } finally {
            showing = false;
        }
    }
}
