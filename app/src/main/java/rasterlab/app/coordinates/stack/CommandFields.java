package rasterlab.app.coordinates.stack;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.widget.NumberField;
import rasterlab.app.language.Texts;

/** Fields for the numbers of the newest command, made anew for another command. */
final class CommandFields extends JPanel {
    private static final long serialVersionUID = 1L;

    private static final double MOST = 1e15;
    private static final int CELLS = 16;

    private final transient StackLabModel model;
    private final transient Texts texts;
    private final transient List<NumberField> fields = new ArrayList<>();
    private transient Optional<StackOp> shown = Optional.empty();

    CommandFields(StackLabModel model, Texts texts) {
        super(new MigLayout("insets 0, gap 6 4", "", ""));
        this.model = model;
        this.texts = texts;
        setName("numbers");
    }

    void refresh() {
        Optional<StackCommand> selected = model.newest();
        Optional<StackOp> op = selected.map(StackCommand::op);
        if (!op.equals(shown)) show(op);
        for (int i = 0; i < fields.size(); i++)
            fields.get(i).show(selected.orElseThrow().numbers().get(i));
    }

    private void show(Optional<StackOp> op) {
        shown = op;
        fields.clear();
        removeAll();
        List<String> names = op.map(StackOp::names).orElse(List.of());
        boolean cells = names.size() == CELLS;
        for (int i = 0; i < names.size(); i++) {
            int index = i;
            var field =
                    new NumberField(
                            "number." + i,
                            texts.text("number.hint", names.get(i)),
                            -MOST,
                            MOST,
                            names.get(i).equals("degrees") ? 5 : 0.25,
                            texts.locale(),
                            value -> model.set(index, value));
            fields.add(field);
            if (!cells) addLabel(names.get(i), i, field);
            int row = cells ? 4 : 2;
            add(field, "w 0, wmin 0, grow, push" + (i % row == row - 1 ? ", wrap" : ""));
        }
        revalidate();
        repaint();
    }

    private void addLabel(String name, int index, NumberField field) {
        var label = new JLabel(name);
        label.setName("number." + index + ".label");
        label.setLabelFor(field);
        add(label);
    }
}
