package rasterlab.app.exercise.panel;

import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import rasterlab.app.canvas.file.LastFolderChooser;
import rasterlab.app.exercise.Closing;
import rasterlab.app.exercise.UnsavedDraft;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** Asks by dialogs before a window closes with sources that are not on the disk. */
public final class ClosingDialog implements Closing.User {
    private final Component window;
    private final Texts texts;

    public ClosingDialog(Component window, Language language) {
        this.window = window;
        texts = Texts.of("exercise", language);
    }

    @Override
    public Closing.ClosingDecision answer(List<UnsavedDraft> unsaved) {
        String listed =
                unsaved.stream()
                        .map(draft -> draft.exercise() + ": " + draft.problem())
                        .collect(Collectors.joining("\n"));
        Object[] answers = {
            texts.text("closing.elsewhere"),
            texts.text("closing.anyway"),
            texts.text("closing.stay")
        };
        int chosen =
                JOptionPane.showOptionDialog(
                        window,
                        texts.text("closing.question", listed),
                        texts.text("closing.title"),
                        JOptionPane.DEFAULT_OPTION,
                        JOptionPane.WARNING_MESSAGE,
                        null,
                        answers,
                        answers[0]);
        if (chosen == 0) return Closing.ClosingDecision.SAVE_ELSEWHERE;
        return chosen == 1 ? Closing.ClosingDecision.CLOSE_ANYWAY : Closing.ClosingDecision.STAY;
    }

    @Override
    public Optional<Path> place(UnsavedDraft draft) {
        var chooser = new LastFolderChooser(texts.language());
        chooser.setName("closing.place");
        chooser.setDialogTitle(texts.text("closing.place", draft.exercise()));
        chooser.setSelectedFile(new File(draft.exercise() + ".java"));
        return chooser.showSaveDialog(window) == JFileChooser.APPROVE_OPTION
                ? Optional.of(chooser.chosen())
                : Optional.empty();
    }

    @Override
    public void tell(String problem) {
        JOptionPane.showMessageDialog(
                window, problem, texts.text("closing.title"), JOptionPane.WARNING_MESSAGE);
    }
}
