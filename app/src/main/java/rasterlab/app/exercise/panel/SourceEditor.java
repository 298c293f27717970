package rasterlab.app.exercise.panel;

import com.formdev.flatlaf.FlatLaf;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.KeyboardFocusManager;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.swing.Icon;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import javax.swing.text.BadLocationException;
import org.fife.ui.rsyntaxtextarea.RSyntaxDocument;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextAreaDefaultInputMap;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextAreaEditorKit;
import org.fife.ui.rsyntaxtextarea.Style;
import org.fife.ui.rsyntaxtextarea.SyntaxConstants;
import org.fife.ui.rsyntaxtextarea.Theme;
import org.fife.ui.rtextarea.RTextScrollPane;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise.TaskKind;

/** The editor of a Java source, with messages at its lines; panels wear it in turn. */
public final class SourceEditor extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient RemarkNotices notices = new RemarkNotices();
    private final Area area = new Area();
    private final RTextScrollPane scroll = new RTextScrollPane(area);
    private final int blinkRate = area.getCaret().getBlinkRate();
    private transient Texts texts;
    private transient List<Outcome.Remark> shown = List.of();
    private String exercise = "";
    private boolean refreshing;

    /**
     * @param typed told the text whenever the user has changed it
     */
    public SourceEditor(Consumer<String> typed) {
        super(new BorderLayout());
        area.setName("source");
        area.setSyntaxEditingStyle(SyntaxConstants.SYNTAX_STYLE_JAVA);
        area.setTabSize(4);
        area.setTabsEmulated(true);
        area.setAntiAliasingEnabled(true);
        area.setPopupMenu(null);
        // Tab indents, and Ctrl+Tab is the window's.
        area.setFocusTraversalKeys(
                KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, Set.of(KeyStroke.getKeyStroke("F6")));
        area.setFocusTraversalKeys(
                KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS,
                Set.of(KeyStroke.getKeyStroke("shift F6")));
        ClosingBrace.in(area);
        area.addParser(notices);
        scroll.setIconRowHeaderEnabled(true);
        scroll.setName("source.scroll");
        area.getDocument()
                .addDocumentListener(
                        new DocumentListener() {
                            @Override
                            public void insertUpdate(DocumentEvent e) {
                                tell();
                            }

                            @Override
                            public void removeUpdate(DocumentEvent e) {
                                tell();
                            }

                            @Override
                            public void changedUpdate(DocumentEvent e) {
                                // styles only
                            }

                            private void tell() {
                                if (!refreshing) typed.accept(area.getText());
                            }
                        });
        add(scroll);
    }

    /** Speaks that language, in the theme that is installed; text, caret and history stay. */
    public void wear(Texts next) {
        texts = next;
        area.getAccessibleContext().setAccessibleName(texts.text("source"));
        Font type = area.getFont();
        SwingUtilities.updateComponentTreeUI(this);
        // The look and feel has just put its own in the place of any.
        area.setTransferHandler(new SourceDrop());
        theme().apply(area);
        setType(type);
        area.getCaret().setBlinkRate(blinkRate);
        List<Outcome.Remark> remarks = shown;
        shown = List.of();
        remark(remarks);
    }

    /** Loads what editors are made of, without making one; on any thread. */
    static void prepare() {
        new RSyntaxDocument(SyntaxConstants.SYNTAX_STYLE_JAVA);
        new RSyntaxTextAreaEditorKit();
        new RSyntaxTextAreaDefaultInputMap();
        theme();
    }

    private static Theme theme() {
        String name = FlatLaf.isLafDark() ? "dark" : "idea";
        try (InputStream in =
                Theme.class.getResourceAsStream(
                        "/org/fife/ui/rsyntaxtextarea/themes/" + name + ".xml")) {
            var theme = Theme.load(in);
            for (Style style : theme.scheme.getStyles())
                if (style != null) makeReadable(style, theme.bgColor);
            return theme;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void makeReadable(Style style, Color paper) {
        Color ground = style.background == null ? paper : style.background;
        if (style.foreground != null && MethodColors.contrast(style.foreground, ground) < 4.5)
            style.foreground = MethodColors.textOn(ground, style.foreground);
    }

    /** Measures its type off the screen too, where a component has no graphics of its own. */
    private static final class Area extends RSyntaxTextArea {
        private static final long serialVersionUID = 1L;

        Area() {
            super(20, 60);
        }

        /** Type that changed while no window had the editor is measured anew. */
        @Override
        public void addNotify() {
            super.addNotify();
            wear(getFont());
        }

        /**
         * Sets the type. The new view that this makes has measured its lines by the old one, so it
         * is made again, as whenever the tabs are set.
         */
        void wear(Font type) {
            setFont(type);
            setTabSize(getTabSize());
        }

        @Override
        public Graphics getGraphics() {
            Graphics own = super.getGraphics();
            return own != null
                    ? own
                    : new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        }
    }

    /**
     * Shows an exercise's text. Another text of the same exercise can be undone.
     *
     * @param id of the exercise
     */
    void show(String id, TaskKind form, String text) {
        area.setSyntaxEditingStyle(
                form == TaskKind.WRITE
                        ? SyntaxConstants.SYNTAX_STYLE_JAVA
                        : SyntaxConstants.SYNTAX_STYLE_JSON);
        refreshing = true;
        if (!id.equals(exercise)) {
            area.setText(text);
            area.setCaretPosition(0);
            area.discardAllEdits();
            exercise = id;
        } else if (!text.equals(area.getText())) {
            area.beginAtomicEdit();
            area.replaceRange(text, 0, area.getDocument().getLength());
            area.endAtomicEdit();
            area.setCaretPosition(0);
        }
        refreshing = false;
    }

    /** Marks the lines that something is said about. */
    void remark(List<Outcome.Remark> remarks) {
        if (remarks.equals(shown)) return;
        shown = remarks;
        notices.show(remarks, texts.language());
        area.forceReparsing(notices);
        scroll.getGutter().removeAllTrackingIcons();
        for (int line : RemarkNotices.lines(remarks)) mark(line, remarks);
    }

    private void mark(int line, List<Outcome.Remark> remarks) {
        if (line > area.getLineCount()) return;
        String said =
                remarks.stream()
                        .filter(one -> one.line() == line)
                        .map(one -> one.message().in(texts.language()))
                        .collect(Collectors.joining("\n"));
        Icon mark = new SmallIcon(UIManager.getIcon("OptionPane.errorIcon"));
        try {
            scroll.getGutter().addLineTrackingIcon(line - 1, mark, said);
        } catch (BadLocationException e) {
            throw new AssertionError("line " + line + " of " + area.getLineCount(), e);
        }
    }

    /**
     * Puts the caret there and gives the editor the keyboard.
     *
     * @param line from 1; one beyond the end is the last
     * @param column from 1; 0 for the line's beginning
     */
    void goTo(int line, int column) {
        int index = Math.max(0, Math.min(line, area.getLineCount()) - 1);
        try {
            int start = area.getLineStartOffset(index);
            int end = area.getLineEndOffset(index);
            area.setCaretPosition(Math.min(start + Math.max(0, column - 1), end));
        } catch (BadLocationException e) {
            throw new AssertionError("line " + index + " of " + area.getLineCount(), e);
        }
        focus();
    }

    void focus() {
        area.requestFocusInWindow();
    }

    /** Binds a key while the editor has the keyboard, before it uses the key itself. */
    void bind(KeyStroke key, Runnable action) {
        KeyBinding.whenFocused(area, key, action);
    }

    void undo() {
        area.undoLastAction();
    }

    void redo() {
        area.redoLastAction();
    }

    boolean canUndo() {
        return area.canUndo();
    }

    boolean canRedo() {
        return area.canRedo();
    }

    /** Stops the caret, whose blinking keeps the program running after its last window. */
    public void close() {
        area.getCaret().setBlinkRate(0);
        area.getCaret().setVisible(false);
    }

    /**
     * @param points of the text
     */
    void setPoints(int points) {
        setType(new Font(Font.MONOSPACED, Font.PLAIN, points));
    }

    private void setType(Font type) {
        area.wear(type);
        scroll.getGutter().setLineNumberFont(type);
    }
}
