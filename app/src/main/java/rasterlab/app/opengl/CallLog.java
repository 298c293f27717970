package rasterlab.app.opengl;

import java.awt.Component;
import java.awt.Font;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;
import javax.swing.ListSelectionModel;
import javax.swing.UIManager;
import rasterlab.app.canvas.StageColours;
import rasterlab.app.language.Texts;
import rasterlab.app.opengl.call.GlCall;
import rasterlab.app.opengl.state.Setting;

/** The calls of a frame, those of one setting in bold. */
final class CallLog extends JList<GlCall> {
    private static final long serialVersionUID = 1L;

    private transient List<String> shown = List.of();
    private transient Optional<Setting> marked = Optional.empty();

    CallLog(Texts texts) {
        setName("calls");
        getAccessibleContext().setAccessibleName(texts.text("calls"));
        setSelectionMode(ListSelectionModel.SINGLE_INTERVAL_SELECTION);
        setFont(new Font(Font.MONOSPACED, Font.PLAIN, UIManager.getFont("Label.font").getSize()));
        setCellRenderer(new CallRenderer());
        setVisibleRowCount(8);
    }

    /** Shows the calls and brings those of the setting into sight. */
    void show(List<GlCall> calls, Setting setting) {
        List<String> texts = calls.stream().map(GlCall::text).toList();
        if (!texts.equals(shown)) {
            shown = texts;
            setListData(calls.toArray(GlCall[]::new));
        } else if (marked.equals(Optional.of(setting))) return;
        marked = Optional.of(setting);
        for (int i = 0; i < calls.size(); i++)
            if (calls.get(i).setting().equals(marked)) {
                ensureIndexIsVisible(Math.min(calls.size() - 1, i + 2));
                ensureIndexIsVisible(i);
                break;
            }
        repaint();
    }

    /** All calls as lines of a program. */
    String program() {
        return shown.stream().map(line -> line + ";\n").collect(Collectors.joining());
    }

    private final class CallRenderer extends DefaultListCellRenderer {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object item, int index, boolean on, boolean focused) {
            var call = (GlCall) item;
            String line = "%3d  %s;".formatted(index + 1, call.text());
            super.getListCellRendererComponent(list, line, index, on, focused);
            setToolTipText(call.text());
            if (call.setting().isPresent() && call.setting().equals(marked)) {
                setFont(getFont().deriveFont(Font.BOLD));
                if (!on) setForeground(StageColours.now().focus());
            }
            return this;
        }
    }
}
