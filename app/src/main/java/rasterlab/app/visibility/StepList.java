package rasterlab.app.visibility;

import java.awt.Component;
import java.util.List;
import javax.swing.AbstractListModel;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;
import javax.swing.ListSelectionModel;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Texts;
import rasterlab.engine.visibility.VisibilityStep;

/** The method's steps in their order; the present one is selected, selecting one goes there. */
final class StepList extends JList<VisibilityStep> {
    private static final long serialVersionUID = 1L;

    private static final int ROWS = 8;

    private final transient VisibilityLabModel model;
    private final transient Texts texts;
    private transient List<VisibilityStep> steps = List.of();
    private boolean refreshing;

    StepList(VisibilityLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        setName("steps");
        getAccessibleContext().setAccessibleName(texts.text("steps"));
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        setVisibleRowCount(ROWS);
        setCellRenderer(new Rows());
        setFixedCellHeight(getFontMetrics(getFont()).getHeight() + 4);
        setFixedCellWidth(10);
        addListSelectionListener(
                e -> {
                    if (!refreshing && getSelectedIndex() >= 0) model.goTo(getSelectedIndex() + 1);
                });
    }

    void refresh() {
        List<VisibilityStep> found = model.state().drawn().map(Drawn::steps).orElse(List.of());
        refreshing = true;
        if (found != steps) {
            steps = found;
            setModel(new Steps(found));
        }
        int selected = Math.min(model.state().step(), steps.size()) - 1;
        if (selected < 0) clearSelection();
        else if (selected != getSelectedIndex()) {
            setSelectedIndex(selected);
            ensureIndexIsVisible(selected);
        }
        refreshing = false;
    }

    private String text(int index, VisibilityStep step) {
        String number = Integer.toString(index + 1);
        String value = Shown.number(step.value(), 3, texts.locale());
        if (step instanceof VisibilityStep.FaceDrawn drawn)
            return texts.text("step.drawn", number, face(drawn.face()), value);
        if (step instanceof VisibilityStep.FaceMoved moved)
            return texts.text("step.moved", number, face(moved.face()), face(moved.before()));
        if (step instanceof VisibilityStep.FaceCut cut)
            return texts.text("step.cut", number, face(cut.face()), face(cut.by()));
        if (step instanceof VisibilityStep.SpanSeen span)
            return texts.text(
                    "step.span",
                    number,
                    face(span.face()),
                    face(span.y()),
                    face(span.from()),
                    face(span.to() - 1));
        var window = (VisibilityStep.Window) step;
        return texts.text(
                window.divided() ? "step.divided" : "step.window",
                number,
                face(window.x()),
                face(window.y()),
                window.width() + " × " + window.height());
    }

    /** The face's number without the language's separators: it is a number of a face or a pixel. */
    private static String face(int number) {
        return Integer.toString(number);
    }

    private static final class Steps extends AbstractListModel<VisibilityStep> {
        private static final long serialVersionUID = 1L;

        private final transient List<VisibilityStep> steps;

        Steps(List<VisibilityStep> steps) {
            this.steps = steps;
        }

        @Override
        public int getSize() {
            return steps.size();
        }

        @Override
        public VisibilityStep getElementAt(int index) {
            return steps.get(index);
        }
    }

    private final class Rows extends DefaultListCellRenderer {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object item, int index, boolean on, boolean focused) {
            String shown = item instanceof VisibilityStep step ? text(index, step) : "";
            return super.getListCellRendererComponent(list, shown, index, on, focused);
        }
    }
}
