package rasterlab.app.exercise.panel;

import java.awt.Component;
import java.awt.Point;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.JTextArea;
import javax.swing.ListCellRenderer;
import javax.swing.ListSelectionModel;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.language.Texts;

/** The remarks about lines of the source; choosing one leads there. */
final class RemarkList extends JList<Outcome.Remark> {
    private static final long serialVersionUID = 1L;

    private final DefaultListModel<Outcome.Remark> items = new DefaultListModel<>();
    private transient List<Outcome.Remark> shown = List.of();

    /**
     * @param chosen told the remark that the user chooses
     */
    RemarkList(Texts texts, Consumer<Outcome.Remark> chosen) {
        setModel(items);
        setName("remarks");
        getAccessibleContext().setAccessibleName(texts.text("remarks"));
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        setCellRenderer(new Lines(texts));
        addListSelectionListener(
                e -> {
                    if (!e.getValueIsAdjusting() && getSelectedValue() != null)
                        chosen.accept(getSelectedValue());
                });
    }

    void show(List<Outcome.Remark> remarks) {
        if (remarks.equals(shown)) return;
        shown = remarks;
        items.clear();
        remarks.forEach(items::addElement);
    }

    /** Whether the list is as wide as what scrolls it: it is, for remarks are wrapped. */
    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    /** Rows keep their heights, which go with the width. */
    @Override
    public void setBounds(int x, int y, int width, int height) {
        boolean wrapsAnew = width != getWidth();
        super.setBounds(x, y, width, height);
        if (!wrapsAnew) return;
        setFixedCellHeight(0);
        setFixedCellHeight(-1);
    }

    /**
     * The index at a place; there is none below the last remark, though a list would choose the
     * last.
     */
    @Override
    public int locationToIndex(Point place) {
        int index = super.locationToIndex(place);
        return index >= 0 && getCellBounds(index, index).contains(place) ? index : -1;
    }

    /** A remark of several lines keeps them: the compiler points at columns with spaces. */
    private static final class Lines implements ListCellRenderer<Outcome.Remark> {
        private final Texts texts;
        private final JTextArea words = Controls.words("remark");

        Lines(Texts texts) {
            this.texts = texts;
            words.setOpaque(true);
            words.setBorder(BorderFactory.createEmptyBorder(2, 4, 2, 4));
        }

        @Override
        public Component getListCellRendererComponent(
                JList<? extends Outcome.Remark> list,
                Outcome.Remark remark,
                int index,
                boolean on,
                boolean focused) {
            String said = remark.message().in(texts.language());
            String text = remark.line() == 0 ? said : texts.text("remark", remark.line(), said);
            words.setText(text);
            words.getAccessibleContext().setAccessibleName(text);
            words.setFont(list.getFont());
            words.setForeground(on ? list.getSelectionForeground() : list.getForeground());
            words.setBackground(on ? list.getSelectionBackground() : list.getBackground());
            words.setSize(Math.max(1, list.getWidth()), Short.MAX_VALUE);
            return words;
        }
    }
}
