package rasterlab.app.shell;

import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.swing.JOptionPane;
import rasterlab.app.language.Texts;

/**
 * Tells what is wrong with the files of the user's: on the standard error stream at once, and in
 * the window together, as soon as there is one.
 */
final class Problems implements Consumer<Problem> {
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
        String lines =
                untold.stream()
                        .map(each -> each.in(frame.language()))
                        .collect(Collectors.joining("\n"));
        untold.clear();
        JOptionPane.showMessageDialog(
                frame, lines, texts.text("problem.title"), JOptionPane.WARNING_MESSAGE);
    }
}
