package rasterlab.app.coordinates.list;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.coordinates.figure.NamedControls;
import rasterlab.app.language.Texts;

/** A list of all matrices that fit the subject, and the button that adds the chosen one. */
final class AddMatrix extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient ListLabModel model;
    private final transient Texts texts;
    private final JButton button;
    private NameChooser names;
    private int dimension;

    AddMatrix(ListLabModel model, Texts texts) {
        super(new MigLayout("insets 0, gap 6", "[grow,fill,0::][]"));
        this.model = model;
        this.texts = texts;
        button = new NamedControls(null, texts).button("add", this::add);
        refresh();
    }

    private void add() {
        model.add((String) names.getSelectedItem());
    }

    void refresh() {
        button.setEnabled(model.choice().items().size() < ListChoice.MOST);
        if (dimension == model.choice().dimension()) return;
        dimension = model.choice().dimension();
        removeAll();
        List<String> all = model.names(dimension);
        names =
                new NameChooser(
                        "matrix",
                        all,
                        name -> name.equals(ListItem.FREE) ? texts.text("matrix.free") : name,
                        name -> {});
        names.setMaximumRowCount(24);
        names.getAccessibleContext().setAccessibleName(texts.text("matrix.said"));
        names.setToolTipText(texts.text("matrix.said"));
        names.show(all.get(1));
        add(names, "wmin 0");
        add(button);
        revalidate();
    }
}
