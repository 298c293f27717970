package rasterlab.app.line;

import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.widget.NumberEntry;
import rasterlab.app.language.Texts;
import rasterlab.engine.line.Segment;

/** One end's coordinates as two number fields. */
final class EndFields extends JPanel {
    private static final long serialVersionUID = 1L;

    private final End end;
    private final transient LineLabModel model;
    private final JSpinner x;
    private final JSpinner y;
    private boolean refreshing;

    EndFields(End end, LineLabModel model, Texts texts) {
        super(new MigLayout("insets 0, gap 6", "[grow,fill,0::][grow,fill,0::]"));
        this.end = end;
        this.model = model;
        x = spinner("x", texts);
        y = spinner("y", texts);
        refresh();
    }

    void refresh() {
        refreshing = true;
        Segment segment = model.state().choice().segment();
        x.setValue((double) end.x(segment));
        y.setValue((double) end.y(segment));
        refreshing = false;
    }

    private JSpinner spinner(String axis, Texts texts) {
        var spinner =
                new JSpinner(
                        new SpinnerNumberModel(
                                0.0, (double) Integer.MIN_VALUE, (double) Integer.MAX_VALUE, 1.0));
        var editor = new NumberEntry(spinner, "0", texts.locale());
        editor.getTextField().setColumns(3);
        editor.getTextField().setName("end." + end + "." + axis + ".text");
        spinner.setEditor(editor);
        spinner.setName("end." + end + "." + axis);
        String name = texts.text("end.coordinate", end.name(), axis);
        spinner.getAccessibleContext().setAccessibleName(name);
        editor.getTextField().getAccessibleContext().setAccessibleName(name);
        spinner.setToolTipText(name);
        spinner.addChangeListener(e -> moved());
        add(spinner, "wmin 0");
        return spinner;
    }

    private void moved() {
        if (!refreshing) model.moveEnd(end, pixel(x), pixel(y));
    }

    private static int pixel(JSpinner spinner) {
        return (int) Math.rint((Double) spinner.getValue());
    }
}
