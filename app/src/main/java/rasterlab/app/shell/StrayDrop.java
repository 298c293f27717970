package rasterlab.app.shell;

import java.awt.Component;
import java.nio.file.Path;
import java.util.Objects;
import javax.swing.JOptionPane;
import javax.swing.TransferHandler;
import rasterlab.app.canvas.file.FileDrop;
import rasterlab.app.language.Texts;

/** Tells where files belong when one was dropped where no lab takes it. */
final class StrayDrop {
    private StrayDrop() {}

    /**
     * @param content of the window, whose labs take the files that are meant for them
     */
    static TransferHandler on(Component content, Texts texts) {
        return new FileDrop(content, texts.language(), file -> tell(content, texts, file));
    }

    private static void tell(Component content, Texts texts, Path file) {
        JOptionPane.showMessageDialog(
                JOptionPane.getFrameForComponent(content),
                sentence(texts, file),
                texts.text("drop.stray.title"),
                JOptionPane.INFORMATION_MESSAGE);
    }

    /**
     * @param file called by its last name; a root has none and is called as it is
     */
    static String sentence(Texts texts, Path file) {
        return texts.text(
                "drop.stray",
                Objects.requireNonNullElse(file.getFileName(), file),
                texts.text("tab.visibility"),
                texts.text("tab.light"),
                texts.text("tab.opengl"));
    }
}
