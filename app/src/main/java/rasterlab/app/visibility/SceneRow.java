package rasterlab.app.visibility;

import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.file.FileDrop;
import rasterlab.app.canvas.file.SceneChooser;
import rasterlab.app.canvas.lab.Actions;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.visibility.scene.SceneFiles;

/** The buttons that open and save scenes; a file may also be dropped on the lab. */
final class SceneRow extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient VisibilityLabModel model;
    private final transient Texts texts;

    SceneRow(VisibilityLabModel model, Texts texts, SceneSaving saving) {
        super(new MigLayout("insets 0, gap 6", "[grow,fill][grow,fill]"));
        this.model = model;
        this.texts = texts;
        add(button("open", this::open), "wmin 0");
        add(button("save", saving::ask), "wmin 0");
    }

    private JButton button(String key, Runnable action) {
        JButton button = KeyedControls.button(key, texts, action);
        button.setMargin(Actions.NARROW);
        return button;
    }

    private void open() {
        new SceneChooser(texts.language())
                .toOpen(getTopLevelAncestor(), texts.text("files.opened"), SceneFiles.ENDINGS)
                .ifPresent(model::open);
    }

    /** Lets files be dropped on a component. */
    static void acceptFiles(JComponent target, VisibilityLabModel model, Language language) {
        target.setTransferHandler(new FileDrop(target, language, model::open));
    }
}
