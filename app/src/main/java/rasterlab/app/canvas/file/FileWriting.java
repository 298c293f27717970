package rasterlab.app.canvas.file;

import java.awt.Component;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.JOptionPane;
import javax.swing.SwingWorker;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.Complaint;

/** Writes a file in the background and tells what was in the way. */
public final class FileWriting {
    private final Component parent;
    private final Language language;
    private final Consumer<Throwable> onFailure;

    /**
     * @param parent of the dialog that shows a {@link Complaint}
     * @param onFailure told on the event thread what writing threw besides
     */
    public FileWriting(Component parent, Language language, Consumer<Throwable> onFailure) {
        this.parent = parent;
        this.language = language;
        this.onFailure = onFailure;
    }

    /**
     * @param title of the dialog that tells why the file could not be written
     * @param writing runs on a thread of its own
     * @param written told the answer on the event thread
     */
    public <T> void write(String title, Callable<T> writing, Consumer<T> written) {
        new SwingWorker<T, Void>() {
            @Override
            protected T doInBackground() throws Exception {
                return writing.call();
            }

            @Override
            protected void done() {
                try {
                    written.accept(get());
                } catch (ExecutionException e) {
                    tell(title, e.getCause());
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
        }.execute();
    }

    private void tell(String title, Throwable failure) {
        if (failure instanceof Complaint)
            JOptionPane.showMessageDialog(
                    JOptionPane.getFrameForComponent(parent),
                    Complaints.translated(language, failure.getMessage()),
                    title,
                    JOptionPane.WARNING_MESSAGE);
        else onFailure.accept(failure);
    }
}
