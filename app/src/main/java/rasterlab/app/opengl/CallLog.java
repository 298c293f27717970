package rasterlab.app.opengl;

import com.formdev.flatlaf.ui.FlatUIUtils;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.ListSelectionModel;
import javax.swing.TransferHandler;
import javax.swing.UIManager;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.language.Texts;
import rasterlab.app.opengl.call.GlCall;
import rasterlab.app.opengl.state.Setting;

/** The calls of a frame, those of one setting in bold; what is too long for a line is broken. */
final class CallLog extends JList<GlCall> {
    private static final long serialVersionUID = 1L;

    /** Letters that a line has room for at least, its number among them. */
    private static final int COLUMNS = 34;

    /** Width of a letter in sizes of its type. */
    private static final float LETTER = 0.6f;

    /** No smaller than so many view units, if labels are not. */
    private static final float LEAST = 14;

    private transient List<String> shown = List.of();
    private transient Optional<Setting> marked = Optional.empty();

    CallLog(Texts texts) {
        setName("calls");
        getAccessibleContext().setAccessibleName(texts.text("calls"));
        setSelectionMode(ListSelectionModel.SINGLE_INTERVAL_SELECTION);
        setFont(new Font(Font.MONOSPACED, Font.PLAIN, UIManager.getFont("Label.font").getSize()));
        setCellRenderer(new CallRenderer());
        setVisibleRowCount(8);
        setTransferHandler(new ProgramCopy());
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        boolean other = width != getWidth();
        super.setBounds(x, y, width, height);
        if (!other) return;
        setFont(getFont().deriveFont(type(width)));
        // A list asks for its rows' heights again where they are no longer fixed.
        setFixedCellHeight(1);
        setFixedCellHeight(-1);
        EventQueue.invokeLater(this::reveal);
    }

    /** The size of type as in labels, smaller where names of calls would be broken. */
    private static float type(int width) {
        float label = UIManager.getFont("Label.font").getSize2D();
        return Math.min(label, Math.max(LEAST, width / (COLUMNS * LETTER)));
    }

    /** No wider than what shows it: calls are broken instead. */
    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    /** Shows the calls and brings those of the setting into sight. */
    void show(List<GlCall> calls, Setting setting) {
        List<String> texts = calls.stream().map(GlCall::text).toList();
        if (!texts.equals(shown)) {
            shown = texts;
            setListData(calls.toArray(GlCall[]::new));
        } else if (marked.equals(Optional.of(setting))) return;
        marked = Optional.of(setting);
        reveal();
        repaint();
    }

    private void reveal() {
        int last = getModel().getSize() - 1;
        for (int i = 0; i <= last; i++)
            if (isMarked(getModel().getElementAt(i))) {
                ensureIndexIsVisible(Math.min(last, i + 2));
                ensureIndexIsVisible(i);
                return;
            }
    }

    private boolean isMarked(GlCall call) {
        return call.setting().isPresent() && call.setting().equals(marked);
    }

    /** All calls as lines of a program. */
    String program() {
        return program(shown);
    }

    private static String program(List<String> calls) {
        return calls.stream().map(line -> line + ";\n").collect(Collectors.joining());
    }

    /** Copies the chosen calls as lines of a program, unbroken. */
    private static final class ProgramCopy extends TransferHandler {
        private static final long serialVersionUID = 1L;

        @Override
        public int getSourceActions(JComponent log) {
            return COPY;
        }

        @Override
        protected Transferable createTransferable(JComponent log) {
            List<GlCall> chosen = ((CallLog) log).getSelectedValuesList();
            return new StringSelection(program(chosen.stream().map(GlCall::text).toList()));
        }
    }

    /** One call with its number, in as many lines as it needs. */
    private final class CallRenderer extends DefaultListCellRenderer {
        private static final long serialVersionUID = 1L;

        /** Columns of the number and what is behind it. */
        private static final int NUMBER = 5;

        private static final int BESIDE = 4;
        private static final int ABOVE = 2;

        private transient List<String> lines = List.of();
        private String number = "";

        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object item, int index, boolean on, boolean focused) {
            var call = (GlCall) item;
            number = "%3d".formatted(index + 1);
            String line = number + "  " + call.text() + ";";
            super.getListCellRendererComponent(list, line, index, on, focused);
            setToolTipText(call.text());
            if (isMarked(call)) {
                setFont(getFont().deriveFont(Font.BOLD));
                if (!on) setForeground(StageColors.now().focus());
            }
            int columns = (list.getWidth() - 2 * BESIDE) / letter();
            lines = CallLines.of(call.text() + ";", columns - NUMBER);
            return this;
        }

        /** Width of one of a type whose letters are all as wide. */
        private int letter() {
            return getFontMetrics(getFont()).charWidth('m');
        }

        @Override
        public Dimension getPreferredSize() {
            int high = getFontMetrics(getFont()).getHeight();
            int columns = lines.stream().mapToInt(String::length).max().orElse(0);
            return new Dimension(
                    2 * BESIDE + (NUMBER + CallLines.INDENT + columns) * letter(),
                    2 * ABOVE + high * lines.size());
        }

        @Override
        protected void paintComponent(Graphics g) {
            g.setColor(getBackground());
            g.fillRect(0, 0, getWidth(), getHeight());
            g.setColor(getForeground());
            g.setFont(getFont());
            int base = ABOVE + g.getFontMetrics().getAscent();
            int left = BESIDE + NUMBER * letter();
            draw(g, number, BESIDE, base);
            for (String line : lines) {
                draw(g, line, left, base);
                base += g.getFontMetrics().getHeight();
                left = BESIDE + (NUMBER + CallLines.INDENT) * letter();
            }
        }

        /** Draws words as smooth as labels are. */
        private void draw(Graphics g, String words, int x, int y) {
            FlatUIUtils.drawString(this, g, words, x, y);
        }
    }
}
