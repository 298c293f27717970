package rasterlab.app.coordinates.stack;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ListSelectionModel;
import javax.swing.ScrollPaneConstants;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.lab.Actions;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.widget.FormulaView;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.coordinates.figure.NamedControls;
import rasterlab.app.language.Texts;
import rasterlab.engine.transform.MatrixMode;

/** The program with its controls, the depths of the stacks and the matrices of the present one. */
final class StackInspector {
    private static final int ROWS = 9;

    private final StackLabModel model;
    private final Texts texts;
    private final Inspector column;

    private final NameChooser command;
    private final JList<String> program = new JList<>(new DefaultListModel<>());
    private final JButton remove;
    private final CommandFields fields;
    private final JLabel newest;
    private final Map<MatrixMode, JLabel> depths = new EnumMap<>(MatrixMode.class);
    private final FormulaView formulas = new FormulaView("stack");
    private boolean refreshing;

    /**
     * @param mode adds the row that leads to the other labs
     */
    StackInspector(StackLabModel model, Texts texts, Consumer<Inspector> mode) {
        this.model = model;
        this.texts = texts;
        column = new Inspector(texts);
        var parts = new NamedControls(column, texts);
        mode.accept(column);
        column.heading("heading.commands");
        column.wide(
                row(
                        parts.button("push", () -> model.add(StackOp.PUSH)),
                        parts.button("pop", () -> model.add(StackOp.POP)),
                        parts.button("identity", () -> model.add(StackOp.IDENTITY))));
        command =
                new NameChooser(
                        "command",
                        Stream.of(StackOp.values()).map(StackOp::code).toList(),
                        this::codeText,
                        code -> {});
        command.setMaximumRowCount(StackOp.values().length);
        command.setToolTipText(texts.text("command.hint"));
        command.getAccessibleContext().setAccessibleName(texts.text("command.hint"));
        command.show(StackOp.TRANSLATE.code());
        column.wide(adding(parts.button("add", this::add)));

        column.heading("heading.program");
        addProgram();
        remove = parts.button("remove", model::remove);
        column.wide(row(remove, parts.button("clear", model::clear)));
        fields = new CommandFields(model, texts);
        column.wide(fields);

        column.heading("heading.stack");
        newest = column.value("newest");
        for (MatrixMode each : MatrixMode.values())
            depths.put(each, column.value("depth." + each.name()));
        column.wide(formulas);
        parts.about().show(texts, "about", "", "");
    }

    private String codeText(String code) {
        StackOp op = StackOp.named(code);
        return op == StackOp.CUBE ? texts.text("op.cube") : op.call();
    }

    private void add() {
        model.add(StackOp.named((String) command.getSelectedItem()));
    }

    private static JPanel row(JButton... buttons) {
        var row = new JPanel(new MigLayout("insets 0, gap 6"));
        for (JButton button : buttons) row.add(button, "grow, push, sg");
        return row;
    }

    private JPanel adding(JButton button) {
        var row = new JPanel(new MigLayout("insets 0, gap 6, wrap 1", "[grow,fill]"));
        row.add(command, "wmin 0");
        button.setMargin(Actions.NARROW);
        row.add(button);
        return row;
    }

    private void addProgram() {
        program.setName("program");
        program.getAccessibleContext().setAccessibleName(texts.text("heading.program"));
        program.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        program.setVisibleRowCount(ROWS);
        program.addListSelectionListener(
                e -> {
                    if (!refreshing && program.getSelectedIndex() >= 0)
                        model.goTo(program.getSelectedIndex() + 1);
                });
        var scroll =
                new JScrollPane(
                        program,
                        ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
                        ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setName("program.scroll");
        column.wide(scroll);
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        var readings = new StackReadings(model, texts);
        showProgram(readings.lines());
        remove.setEnabled(model.step() > 0);
        fields.refresh();
        newest.setText(readings.newest());
        depths.forEach((mode, label) -> label.setText(readings.depth(mode)));
        formulas.show(readings.stack());
    }

    private void showProgram(List<String> lines) {
        refreshing = true;
        var shown = (DefaultListModel<String>) program.getModel();
        for (int i = 0; i < lines.size(); i++)
            if (i >= shown.size()) shown.addElement(lines.get(i));
            else if (!shown.get(i).equals(lines.get(i))) shown.set(i, lines.get(i));
        while (shown.size() > lines.size()) shown.remove(shown.size() - 1);
        if (model.step() == 0) program.clearSelection();
        else program.setSelectedIndex(model.step() - 1);
        program.ensureIndexIsVisible(Math.max(0, model.step() - 1));
        refreshing = false;
    }
}
