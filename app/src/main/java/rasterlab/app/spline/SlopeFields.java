package rasterlab.app.spline;

import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.widget.NumberEntry;
import rasterlab.app.language.Texts;
import rasterlab.contract.SplineEnds;

/** The slopes at the end knots as two number fields. */
final class SlopeFields extends JPanel {
    private static final long serialVersionUID = 1L;

    private static final double STEP = 0.1;

    private final transient FunctionLabModel model;
    private final JSpinner left;
    private final JSpinner right;
    private boolean refreshing;

    SlopeFields(FunctionLabModel model, Texts texts) {
        super(new MigLayout("insets 0, gap 6", "[grow,fill,0::][grow,fill,0::]"));
        this.model = model;
        left = spinner("slope.left", texts);
        right = spinner("slope.right", texts);
    }

    void show(SplineEnds ends) {
        refreshing = true;
        left.setValue(ends.left());
        right.setValue(ends.right());
        refreshing = false;
    }

    private JSpinner spinner(String key, Texts texts) {
        var spinner = new JSpinner(new SpinnerNumberModel(0.0, -1e100, 1e100, STEP));
        var editor = new NumberEntry(spinner, "0.####", texts.locale());
        editor.getTextField().setColumns(4);
        editor.getTextField().setName(key + ".text");
        spinner.setEditor(editor);
        spinner.setName(key + ".field");
        String said = texts.text(key);
        spinner.getAccessibleContext().setAccessibleName(said);
        editor.getTextField().getAccessibleContext().setAccessibleName(said);
        spinner.setToolTipText(said);
        spinner.addChangeListener(
                e -> {
                    if (!refreshing)
                        model.chooseEnds(
                                SplineEnds.slopes(
                                        (Double) left.getValue(), (Double) right.getValue()));
                });
        add(spinner, "wmin 0");
        return spinner;
    }
}
