package rasterlab.app.coordinates.list;

import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.widget.FormulaView;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.coordinates.figure.NamedControls;
import rasterlab.app.coordinates.figure.NumberTable;
import rasterlab.app.language.Texts;

/** The list with its controls, the matrices and the coordinate table. */
final class ListInspector {
    private static final List<String> EXAMPLES =
            Stream.of(Example.values()).map(Example::code).toList();

    /** The entry in the list of examples while another list is shown. */
    private static final String OWN = "own";

    private final ListLabModel model;
    private final Texts texts;
    private final Texts explanations;
    private final Inspector column;
    private NameChooser example;
    private final NameChooser subject;
    private final NameChooser reading;
    private final TrialRows tried;
    private final JList<String> list = new JList<>(new DefaultListModel<>());
    private final JButton remove;
    private final JButton earlier;
    private final JButton later;
    private final ItemFields fields;
    private final AddMatrix add;
    private final JLabel done;
    private final JLabel error;
    private final WrappedText meaning;
    private final FormulaView formulas = new FormulaView("formulas");
    private final NumberTable table;
    private final AboutText about;
    private boolean refreshing;

    /**
     * @param mode adds the row that leads to the other labs
     */
    ListInspector(ListLabModel model, Texts texts, Consumer<Inspector> mode) {
        this.model = model;
        this.texts = texts;
        explanations = TopicTexts.of("matrix", texts.language()).texts();
        column = new Inspector(texts);
        var parts = new NamedControls(column, texts);
        mode.accept(column);
        addExamples();
        subject =
                parts.names(
                        "subject",
                        Stream.of(Subject.values()).map(Subject::code).toList(),
                        code -> model.choose(Subject.named(code)));
        reading =
                parts.names(
                        "reading",
                        Stream.of(Reading.values()).map(Reading::code).toList(),
                        code -> model.read(Reading.named(code)));
        tried = new TrialRows(model, texts, column);

        column.heading("heading.list");
        addList();
        add = new AddMatrix(model, texts);
        column.wide(add);
        remove = parts.button("remove", model::remove);
        earlier = parts.button("earlier", () -> model.move(-1));
        later = parts.button("later", () -> model.move(1));
        var buttons =
                new JPanel(new MigLayout("insets 0, gap 6", "[grow,fill][grow,fill][grow,fill]"));
        for (JButton button : List.of(remove, earlier, later)) buttons.add(button, "wmin 0");
        column.wide(buttons);
        meaning = new WrappedText("meaning");
        column.wide(meaning);
        fields = new ItemFields(model, texts);
        column.wide(fields);

        column.heading("heading.step");
        done = column.value("done");
        error = column.value("error");
        column.wide(formulas);
        column.heading("heading.table");
        table = parts.table("heading.table");
        about = parts.about();
    }

    private void addExamples() {
        example =
                new NameChooser(
                        "example",
                        EXAMPLES,
                        code -> texts.text("example." + code),
                        this::chooseExample);
        example.setMaximumRowCount(EXAMPLES.size() + 1);
        column.row("example", example);
    }

    /** A list of one's own is shown already. */
    private void chooseExample(String code) {
        if (!code.equals(OWN)) model.show(Example.named(code));
    }

    private void addList() {
        list.setName("list");
        list.getAccessibleContext().setAccessibleName(texts.text("heading.list"));
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.addListSelectionListener(
                e -> {
                    if (!refreshing && list.getSelectedIndex() >= 0)
                        model.select(list.getSelectedIndex());
                });
        column.wide(list);
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        ListChoice choice = model.choice();
        example.showListed(Example.shown(choice).map(Example::code).orElse(OWN), EXAMPLES);
        example.setToolTipText(null);
        subject.show(choice.subject().code());
        reading.show(choice.reading().code());
        tried.refresh();
        showList(choice);
        add.refresh();
        remove.setEnabled(choice.selected() >= 0);
        earlier.setEnabled(choice.selected() > 0);
        later.setEnabled(choice.selected() >= 0 && choice.selected() < choice.items().size() - 1);
        fields.refresh();
        var readings = new ListReadings(model, texts);
        meaning.show(readings.meaning(explanations));
        done.setText(readings.done());
        error.setText(readings.error());
        formulas.show(readings.formulas());
        if (model.choice().trial().isPresent()) tried.show(table, about);
        else showMatrices(readings);
    }

    private void showMatrices(ListReadings readings) {
        table.show(readings.headings(), readings.rows(), -1);
        about.show(
                explanations,
                model.method().name(),
                "",
                model.scene().isRefused() ? ListReadings.refusal(model.scene(), texts) : "");
    }

    private void showList(ListChoice choice) {
        refreshing = true;
        var shown = (DefaultListModel<String>) list.getModel();
        for (int i = 0; i < choice.items().size(); i++) {
            String said = ListReadings.item(choice.items().get(i), i + 1, texts);
            if (i >= shown.size()) shown.addElement(said);
            else if (!shown.get(i).equals(said)) shown.set(i, said);
        }
        while (shown.size() > choice.items().size()) shown.remove(shown.size() - 1);
        if (choice.selected() < 0) list.clearSelection();
        else list.setSelectedIndex(choice.selected());
        list.setVisibleRowCount(Math.max(1, shown.size()));
        refreshing = false;
    }
}
