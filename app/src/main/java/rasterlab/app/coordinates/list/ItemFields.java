package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.widget.NumberField;
import rasterlab.app.language.Texts;
import rasterlab.engine.transform.matrix.MatrixParameter;
import rasterlab.engine.transform.matrix.NamedMatrices;

/** Fields for the numbers of the selected matrix, made anew for another name. */
final class ItemFields extends JPanel {
    private static final long serialVersionUID = 1L;

    private static final double MOST = 1e15;

    private final transient ListLabModel model;
    private final transient Texts texts;
    private final transient List<NumberField> fields = new ArrayList<>();
    private String shown = "";

    ItemFields(ListLabModel model, Texts texts) {
        super(new MigLayout("insets 0, gap 6 4, hidemode 3", "", ""));
        this.model = model;
        this.texts = texts;
        setName("numbers");
    }

    void refresh() {
        ListChoice choice = model.choice();
        if (choice.selected() < 0) {
            show("", List.of());
            return;
        }
        ListItem item = choice.items().get(choice.selected());
        String kind = item.name() + item.numbers().size();
        if (!kind.equals(shown)) show(kind, names(item));
        for (int i = 0; i < fields.size(); i++) fields.get(i).show(item.numbers().get(i));
    }

    /** The names of the numbers; the cells of a free matrix are called by row and column. */
    private List<String> names(ListItem item) {
        var names = new ArrayList<String>();
        if (item.free()) {
            int size = item.dimension() + 1;
            for (int i = 0; i < item.numbers().size(); i++)
                names.add((i / size + 1) + "," + (i % size + 1));
            return names;
        }
        for (MatrixParameter parameter : NamedMatrices.named(item.name()).parameters())
            for (int i = 0; i < parameter.size(); i++)
                names.add(
                        parameter.size() == 1
                                ? parameter.name()
                                : parameter.name() + "." + "xyz".charAt(i));
        return names;
    }

    private void show(String kind, List<String> names) {
        shown = kind;
        fields.clear();
        removeAll();
        boolean free = kind.startsWith(ListItem.FREE);
        int size = names.size() == 16 ? 4 : 3;
        for (int i = 0; i < names.size(); i++) {
            NumberField field = field(i, names.get(i));
            fields.add(field);
            if (free)
                add(field, "w 0, wmin 0, grow, push" + (i % size == size - 1 ? ", wrap" : ""));
            else addNamed(field, names.get(i), i);
        }
        revalidate();
        repaint();
    }

    private void addNamed(NumberField field, String name, int index) {
        var label = new JLabel(label(name));
        label.setName("number." + index + ".label");
        label.setLabelFor(field);
        add(label);
        add(field, "w 0, wmin 0, grow, push" + (index % 2 == 1 ? ", wrap" : ""));
    }

    private NumberField field(int index, String name) {
        return new NumberField(
                "number." + index,
                texts.text("number.hint", label(name)),
                -MOST,
                MOST,
                step(name),
                texts.locale(),
                value -> model.set(index, value));
    }

    /** Letters are the course's in every language, words are translated. */
    private String label(String name) {
        String[] parts = name.split("\\.");
        String word = texts.textOr("number.name." + parts[0], parts[0]);
        return parts.length == 1 ? word : word + "." + parts[1];
    }

    private static double step(String name) {
        return switch (name) {
            case "angle", "alpha", "beta", "theta", "phi", "fovy" -> 5;
            case "p", "q", "r" -> 0.01;
            case "width", "height", "x", "y" -> 0.5;
            default -> 0.25;
        };
    }
}
