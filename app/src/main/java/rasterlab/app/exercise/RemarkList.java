package rasterlab.app.exercise;

import java.awt.Component;
import java.awt.Font;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.DefaultListCellRenderer;
import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.ListSelectionModel;
import rasterlab.app.language.Texts;

/** What is said about lines of the source; a choice leads there. */
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

    /** A remark of several lines keeps them: the compiler points at columns with spaces. */
    private static final class Lines extends DefaultListCellRenderer {
        private static final long serialVersionUID = 1L;

        private final transient Texts texts;

        Lines(Texts texts) {
            this.texts = texts;
        }

        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object item, int index, boolean on, boolean focused) {
            var remark = (Outcome.Remark) item;
            String said = remark.said().in(texts.language());
            String text = remark.line() == 0 ? said : texts.text("remark", remark.line(), said);
            super.getListCellRendererComponent(list, html(text), index, on, focused);
            setFont(list.getFont().deriveFont(Font.PLAIN));
            return this;
        }

        private static String html(String text) {
            String escaped = text.replace("&", "&amp;").replace("<", "&lt;").replace("\n", "<br>");
            return "<html>" + escaped.replace("  ", "&nbsp; ") + "</html>";
        }
    }
}
