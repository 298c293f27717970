package rasterlab.app.opengl;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.GraphicsEnvironment;
import java.awt.GridLayout;
import java.awt.Point;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import rasterlab.app.canvas.DevicePixels;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.file.FileDrop;
import rasterlab.app.canvas.work.Settling;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Texts;

/**
 * Four fields: OpenGL's picture, the software pipeline's, their difference, and the frame's calls.
 *
 * <p>On a screen OpenGL's picture is a window of its own over the field's; the field shows the same
 * picture read back, so that it is there for copies and without a screen.
 */
final class OpenGlStage extends JPanel implements Settling {
    private static final long serialVersionUID = 1L;

    /** Degrees that an arrow key turns. */
    private static final double KEY = 5;

    private static final double ZOOM = 1.1;

    private final transient OpenGlLabModel model;
    private final transient Texts texts;
    private final PicturePane openGl;
    private final PicturePane software;
    private final PicturePane difference;
    private final CallLog log;
    private final FittingText reading = new FittingText("reading");
    private transient volatile Optional<GlWindow> window = Optional.empty();
    private transient Optional<Point> pointed = Optional.empty();
    private boolean unusable;

    OpenGlStage(OpenGlLabModel model, Texts texts, Consumer<Path> onImage) {
        super(new BorderLayout(0, 4));
        this.model = model;
        this.texts = texts;
        openGl =
                new PicturePane(
                        "opengl.picture",
                        texts.text("openGl"),
                        () -> model.state().pictures().openGl(),
                        this::missing,
                        this::resized);
        software =
                new PicturePane(
                        "software.picture",
                        texts.text("software"),
                        () -> model.state().pictures().software(),
                        () -> texts.text("drawing"),
                        () -> {});
        difference =
                new PicturePane(
                        "difference.picture",
                        texts.text("difference"),
                        () ->
                                model.state()
                                        .pictures()
                                        .difference()
                                        .map(found -> found.plain().mask()),
                        () -> texts.text("difference.none"),
                        () -> {});
        log = new CallLog(texts);
        openGl.setLayout(new BorderLayout());
        var fields = new JPanel(new GridLayout(2, 2, 8, 6));
        fields.add(field("openGl", openGl));
        fields.add(field("software", software));
        fields.add(field("difference", difference));
        fields.add(field("calls", new JScrollPane(log)));
        add(fields);
        reading.setMinimumSize(new Dimension());
        add(reading, BorderLayout.SOUTH);
        setTransferHandler(new FileDrop(this, texts.language(), onImage));
        listen();
        refresh();
    }

    private String missing() {
        return model.state()
                .missing()
                .map(reason -> Complaints.translated(texts.language(), reason))
                .map(reason -> texts.text("missing", reason))
                .orElse(texts.text("drawing"));
    }

    private JPanel field(String key, JComponent content) {
        var label = new FittingText("title." + key);
        label.setFont(label.getFont().deriveFont(Font.BOLD));
        label.show(texts.text(key), texts.textOr(key + ".brief", texts.text(key)));
        var field = new JPanel(new BorderLayout(0, 4));
        field.add(label, BorderLayout.NORTH);
        field.add(content);
        return field;
    }

    private void listen() {
        var turning = new Turning(model, software::requestFocusInWindow, this::point);
        for (PicturePane pane : new PicturePane[] {openGl, software, difference})
            turning.listenTo(pane);
        software.setFocusable(true);
        software.addFocusListener(
                new FocusAdapter() {
                    @Override
                    public void focusGained(FocusEvent e) {
                        software.repaint();
                    }

                    @Override
                    public void focusLost(FocusEvent e) {
                        software.repaint();
                    }
                });
        software.getAccessibleContext().setAccessibleDescription(texts.text("stage.hint"));
        bind(KeyEvent.VK_UP, 0, -KEY);
        bind(KeyEvent.VK_DOWN, 0, KEY);
        bind(KeyEvent.VK_LEFT, -KEY, 0);
        bind(KeyEvent.VK_RIGHT, KEY, 0);
        for (String key : new String[] {"typed +", "typed ="}) zoom(key, 1 / ZOOM);
        zoom("typed -", ZOOM);
    }

    private void bind(int key, double right, double down) {
        KeyBinding.whenFocused(
                software,
                KeyStroke.getKeyStroke(key, 0),
                () -> model.move(choice -> choice.turned(right, down)));
    }

    private void zoom(String key, double factor) {
        KeyBinding.whenFocused(
                software,
                KeyStroke.getKeyStroke(key),
                () -> model.move(choice -> choice.dollied(factor)));
    }

    /** The picture that has the keyboard: its keys turn the scene. */
    PicturePane picture() {
        return software;
    }

    CallLog log() {
        return log;
    }

    /** The fields as an SVG document: the pictures as pictures, the calls as text. */
    SvgDrawing svg() {
        return SvgPicture.of(this, this::print);
    }

    private void resized() {
        if (openGl.getWidth() < 1 || openGl.getHeight() < 1) return;
        double scale = DevicePixels.scale(this);
        model.resize(
                DevicePixels.count(openGl.getWidth(), scale),
                DevicePixels.count(openGl.getHeight(), scale));
        window.ifPresent(GlWindow::open);
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(800, 600);
    }

    /** Adds OpenGL's window where there is a screen. */
    @Override
    public void addNotify() {
        super.addNotify();
        if (GraphicsEnvironment.isHeadless() || unusable || window.isPresent()) return;
        window = Optional.of(new GlWindow(model, openGl, this::canvas, this::giveUp));
    }

    private GlCanvas canvas() {
        var canvas = new GlCanvas(model, this::giveUp);
        new Turning(model, software::requestFocusInWindow, this::point).listenTo(canvas);
        return canvas;
    }

    @Override
    public void removeNotify() {
        dropWindow();
        super.removeNotify();
    }

    private void giveUp() {
        unusable = true;
        dropWindow();
    }

    private void dropWindow() {
        window.ifPresent(GlWindow::close);
        window = Optional.empty();
    }

    @Override
    public void settle() throws InterruptedException {
        model.settle();
        Optional<GlWindow> coming = window;
        if (coming.isPresent()) coming.get().settle();
    }

    /** Shows the model's present state. */
    void refresh() {
        OpenGlLabState state = model.state();
        window.ifPresent(GlWindow::drawIfStale);
        log.show(state.calls(), state.touched());
        for (Component pane : new Component[] {openGl, software, difference}) pane.repaint();
        read();
    }

    private void point(Optional<Point> at) {
        pointed = at;
        read();
    }

    private void read() {
        double scale = DevicePixels.scale(this);
        Optional<PixelReading> read =
                pointed.flatMap(
                        at ->
                                PixelReading.at(
                                        model.state().pictures(),
                                        (int) (at.x * scale),
                                        (int) (at.y * scale)));
        reading.show(
                read.map(found -> found.text(texts, "reading")).orElse(texts.text("stage.hint")),
                read.map(found -> found.text(texts, "reading.brief"))
                        .orElse(texts.text("stage.hint.brief")));
    }
}
