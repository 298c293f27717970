package rasterlab.app.canvas.lab;

import java.awt.Insets;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.file.Copying;
import rasterlab.app.canvas.file.PictureSaving;
import rasterlab.app.canvas.file.ShownPicture;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.canvas.work.History;
import rasterlab.app.language.Texts;

/** The buttons below the inspector: undo, redo, reset, save, copy. */
public final class Actions extends JPanel {
    private static final long serialVersionUID = 1L;

    /**
     * Margins that are narrower than usual, so that the longest Russian text fits half the
     * inspector.
     */
    public static final Insets NARROW = new Insets(2, 4, 2, 4);

    private static final List<String> REDO_KEYS = List.of("ctrl Y", "ctrl shift Z");

    /** The name of the button that asks for steps. */
    public static final String QUESTIONS = "questions";

    private static final String HALF = "wmin pref";

    private final transient Texts texts;
    private final transient MigLayout grid;
    private final Map<String, JButton> buttons = new HashMap<>();

    /** The outcome of the button pressed last, where it is not seen elsewhere. */
    private final WrappedText status = new WrappedText("status");

    private transient Optional<History<?>> history = Optional.empty();
    private transient Runnable onChange = () -> {};
    private long changes;

    /** Receives what could not be copied; set by {@link #addPicture}. */
    private transient Optional<Consumer<Throwable>> onFailure = Optional.empty();

    public Actions(Texts texts) {
        grid = new MigLayout("insets 0 2 0 10, gap 6, wrap 2", "[grow,fill,50%][grow,fill,50%]");
        setLayout(grid);
        this.texts = texts;
        status.setVisible(false);
        add(status, "north, hidemode 3, wmin 0, gap 2 12 0 6");
    }

    /**
     * @param key the button's name; its text is {@code action.KEY}, its hint {@code
     *     action.KEY.hint}
     */
    public void add(String key, Runnable action) {
        place(button(key, action));
    }

    private JButton button(String key, Runnable action) {
        var button = new JButton(texts.label("action." + key));
        button.setName(key);
        button.setMnemonic(texts.mnemonic("action." + key));
        button.setDisplayedMnemonicIndex(texts.mnemonicIndex("action." + key));
        button.setMargin(NARROW);
        button.setToolTipText(texts.text("action." + key + ".hint"));
        button.addActionListener(
                e -> {
                    status.setVisible(false);
                    action.run();
                });
        buttons.put(key, button);
        return button;
    }

    /** The last button takes both columns where it would stand alone. */
    private void place(JButton button) {
        int last = getComponentCount() - 1;
        boolean alone = last % 2 == 0;
        if (!alone) grid.setComponentConstraints(getComponent(last), HALF);
        add(button, alone ? "span 2, " + HALF : HALF);
    }

    /**
     * Adds buttons that save and copy what the lab shows.
     *
     * @param refused told what could not be copied or saved
     */
    public void addPicture(ShownPicture picture, Consumer<Throwable> refused) {
        var saving = new PictureSaving(picture, this, texts.language(), this::saved, refused);
        onFailure = Optional.of(refused);
        Runnable drawing = () -> tell(texts.text("copied.copySvg"));
        add("savePicture", saving::ask);
        add("copyPicture", () -> Copying.toSystem().picture(picture, this::copied, refused));
        add("copySvg", () -> Copying.toSystem().svg(picture, drawing, refused));
    }

    /**
     * Adds a button that copies a text, behind those of {@link #addPicture}.
     *
     * @param key the button's name; what is said of the copied text is {@code copied.KEY}, whose
     *     argument is how many lines it has
     * @param text makes the text, at once or after it has asked the user, and tells it; or tells
     *     nothing
     */
    public void addCopy(String key, Consumer<Consumer<String>> text) {
        Consumer<Throwable> refused = onFailure.orElseThrow();
        add(key, () -> text.accept(made -> copy(key, made, refused)));
    }

    /**
     * Adds a button, behind all others and as wide as two, that asks for the next step of a method
     * in place of the lab.
     *
     * @param topic whose methods the lab shows when the button is pressed
     */
    public void addQuestions(Supplier<String> topic) {
        Runnable asking =
                () -> {
                    if (SwingUtilities.getAncestorOfClass(StepQuestions.class, this)
                            instanceof StepQuestions place) place.ask(topic.get());
                };
        add(button(QUESTIONS, asking), "newline, span 2, " + HALF);
    }

    private void copy(String key, String text, Consumer<Throwable> refused) {
        String copied = texts.text("copied." + key, text.lines().count());
        Copying.toSystem().text(text, () -> tell(copied), refused);
    }

    private void copied(BufferedImage dots) {
        tell(texts.text("copied.copyPicture", dots.getWidth(), dots.getHeight()));
    }

    /** Says above the buttons which file is written. */
    public void saved(Path file) {
        tell(texts.text("saved", file.toAbsolutePath().toString()));
    }

    /**
     * Says what came of a button, until another is pressed: above the buttons, which keep their
     * place at the lower edge of the inspector.
     */
    public void tell(String sentence) {
        status.show(sentence);
        // This makes the label as high as its sentence needs at its present width.
        status.setSize(Math.max(1, getWidth() - 14), Short.MAX_VALUE);
        status.setVisible(true);
        revalidate();
    }

    /** Adds buttons for undo and redo; {@link #refreshUndo} enables them. */
    public void addUndo(History<?> changes) {
        add("undo", changes::undo);
        add("redo", changes::redo);
        history = Optional.of(changes);
        this.changes = changes.changes();
    }

    /** Returns the description of the last change that can be undone, if there is one. */
    Optional<History<?>> history() {
        return history;
    }

    /** Runs it in {@link #refreshUndo} whenever something was changed or undone since. */
    void whenChanged(Runnable told) {
        onChange = told;
    }

    /** Binds the keys for undo and redo in a lab. */
    public static void bindUndo(JComponent lab, History<?> changes) {
        KeyBinding.within(lab, KeyStroke.getKeyStroke("ctrl Z"), changes::undo);
        for (String key : REDO_KEYS)
            KeyBinding.within(lab, KeyStroke.getKeyStroke(key), changes::redo);
    }

    /** Lets undo and redo be pressed where there is something to undo or redo. */
    public void refreshUndo() {
        enable("undo", history.filter(History::undoable).isPresent());
        enable("redo", history.filter(History::redoable).isPresent());
        long now = history.map(History::changes).orElse(changes);
        if (now == changes) return;
        changes = now;
        onChange.run();
    }

    /** Says something else of a button than its usual hint. */
    public void hint(String key, String text) {
        buttons.get(key).setToolTipText(text);
    }

    /** A button that is disabled leaves the keyboard to the picture, not to the next button. */
    public void enable(String key, boolean enabled) {
        JButton button = buttons.get(key);
        boolean leaves = !enabled && (button.isFocusOwner() || button.getModel().isArmed());
        button.setEnabled(enabled);
        if (leaves
                && SwingUtilities.getAncestorOfClass(LabPanel.class, this) instanceof LabPanel lab)
            lab.focusPicture();
    }
}
