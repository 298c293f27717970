package rasterlab.app.shell;

import java.awt.EventQueue;
import java.awt.Font;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.Problem;

/**
 * Tells what is wrong with the files of the user's: on the error stream at once, and in the window
 * together, as soon as there is one.
 */
final class Problems implements Consumer<Problem> {
    /** Length of a line that is read easily, and that the smallest window has room for. */
    private static final int LETTERS = 70;

    private final PrintStream err;
    private final List<Problem> untold = new ArrayList<>();
    private volatile Language language;
    private LabFrame frame;

    /**
     * @param language of the error stream, until the window's is known
     */
    Problems(PrintStream err, Language language) {
        this.err = err;
        this.language = language;
    }

    void speak(Language next) {
        language = next;
    }

    @Override
    public void accept(Problem problem) {
        err.println("rasterlab: " + problem.in(language));
        EventQueue.invokeLater(() -> add(problem));
    }

    private void add(Problem problem) {
        untold.add(problem);
        if (frame != null) tell();
    }

    /** Shows the problems in a window, on the event thread. */
    void showIn(LabFrame shown) {
        EventQueue.invokeLater(
                () -> {
                    frame = shown;
                    tell();
                });
    }

    private void tell() {
        if (untold.isEmpty() || !frame.isShowing()) return;
        Texts texts = Texts.of("shell", frame.language());
        List<String> said = untold.stream().map(each -> each.in(frame.language())).toList();
        untold.clear();
        JOptionPane.showMessageDialog(
                frame,
                notices(said, UIManager.getFont("Label.font")),
                texts.text("problem.title"),
                JOptionPane.WARNING_MESSAGE);
    }

    /** A paragraph for each problem, with lines of about {@link #LETTERS} letters. */
    static JComponent notices(List<String> said, Font font) {
        var panel = new JPanel(new MigLayout("insets 0, fill, wrap 1, gapy unrel"));
        for (String each : said) {
            var text = new WrappedText("problem");
            text.setFont(font);
            text.show(each);
            panel.add(text, "width " + LETTERS * text.getFontMetrics(font).charWidth('n') + "!");
        }
        return panel;
    }
}
