package rasterlab.app.visibility;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.TransferHandler;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Texts;
import rasterlab.app.model.SceneText;

/** The buttons that open and save scenes; a file may also be dropped on the lab. */
final class SceneRow extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient VisibilityLabModel model;
    private final transient Texts texts;

    SceneRow(VisibilityLabModel model, Texts texts) {
        super(new MigLayout("insets 0, gap 6", "[grow,fill,sg][grow,fill,sg]"));
        this.model = model;
        this.texts = texts;
        add(button("open", this::open), "wmin 0");
        add(button("save", this::save), "wmin 0");
    }

    private JButton button(String key, Runnable action) {
        var button = new JButton(texts.label(key));
        button.setName(key);
        button.setMnemonic(texts.mnemonic(key));
        button.setDisplayedMnemonicIndex(texts.mnemonicIndex(key));
        button.setToolTipText(texts.text(key + ".hint"));
        button.addActionListener(e -> action.run());
        return button;
    }

    private void open() {
        new SceneChooser(texts).toOpen(top()).ifPresent(model::open);
    }

    private void save() {
        new SceneChooser(texts).toSave(top(), fileName()).ifPresent(model::save);
    }

    private String fileName() {
        String name = model.state().choice().scene();
        return name.replaceFirst("(\\.scene)?\\.[a-zA-Z]+$", "") + SceneText.EXTENSION;
    }

    private Component top() {
        return getTopLevelAncestor();
    }

    /** Lets files be dropped on a component. */
    static void acceptFiles(
            JComponent target, VisibilityLabModel model, Consumer<Throwable> onFailure) {
        target.setTransferHandler(new Dropped(model, onFailure));
    }

    private static final class Dropped extends TransferHandler {
        private static final long serialVersionUID = 1L;

        private final transient VisibilityLabModel model;
        private final transient Consumer<Throwable> onFailure;

        Dropped(VisibilityLabModel model, Consumer<Throwable> onFailure) {
            this.model = model;
            this.onFailure = onFailure;
        }

        @Override
        public boolean canImport(TransferSupport support) {
            return support.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
        }

        @Override
        public boolean importData(TransferSupport support) {
            if (!canImport(support)) return false;
            try {
                var files =
                        (List<?>)
                                support.getTransferable()
                                        .getTransferData(DataFlavor.javaFileListFlavor);
                if (files.isEmpty()) return false;
                Path file = ((File) files.get(0)).toPath();
                EventQueue.invokeLater(() -> model.open(file));
                return true;
            } catch (UnsupportedFlavorException | IOException e) {
                onFailure.accept(e);
                return false;
            }
        }
    }
}
