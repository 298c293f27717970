package rasterlab.app.shell;

import java.awt.EventQueue;
import java.awt.FontMetrics;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.swing.JOptionPane;
import javax.swing.UIManager;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.language.Texts;

/**
 * Tells what is wrong with the files of the user's: on the standard error stream at once, and in
 * the window together, as soon as there is one.
 */
final class Problems implements Consumer<Problem> {
    /** Of a line that is read easily, and that the smallest window has room for. */
    private static final int LETTERS = 70;

    private final List<Problem> untold = new ArrayList<>();
    private LabFrame frame;

    @Override
    public void accept(Problem problem) {
        System.err.println("rasterlab: " + problem);
        EventQueue.invokeLater(() -> add(problem));
    }

    private void add(Problem problem) {
        untold.add(problem);
        if (frame != null) tell();
    }

    /** On the event thread. */
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
                lines(said, frame.getFontMetrics(UIManager.getFont("Label.font"))),
                texts.text("problem.title"),
                JOptionPane.WARNING_MESSAGE);
    }

    /** Each problem in lines of about {@link #LETTERS} letters. */
    static String lines(List<String> said, FontMetrics metrics) {
        int room = LETTERS * metrics.charWidth('n');
        return said.stream()
                .flatMap(each -> Wrapping.lines(each, room, metrics::stringWidth).stream())
                .collect(Collectors.joining("\n"));
    }
}
