package rasterlab.app.opengl;

import java.awt.Font;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.text.DefaultCaret;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Texts;
import rasterlab.app.opengl.call.GlCall;
import rasterlab.app.opengl.context.GlReport;
import rasterlab.app.opengl.software.Deviations;
import rasterlab.app.opengl.state.Group;

/** The OpenGL lab's states, live numbers and what is known of the difference. */
final class OpenGlInspector {
    /** More are seen in the log. */
    private static final int MOST_CALLS = 4;

    private final OpenGlLabModel model;
    private final Texts texts;
    private final Inspector column;
    private final NameChooser group;
    private final SettingRows rows;
    private JButton open;
    private JLabel file;
    private JTextArea problem;
    private JTextArea call;
    private JLabel off;
    private JLabel rounded;
    private JLabel largest;
    private JTextArea why;
    private JLabel version;
    private JLabel renderer;
    private JLabel limits;

    OpenGlInspector(OpenGlLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        column = new Inspector(texts);
        group =
                new NameChooser(
                        "group",
                        Arrays.stream(Group.values()).map(Group::code).toList(),
                        name -> texts.text("group." + name),
                        name -> model.touch(named(name).settings().get(0)));
        group.setLightWeightPopupEnabled(false);
        column.row("group", group);
        rows = new SettingRows(model, texts, column, this::chooseImage);
    }

    /**
     * The sections that the constructor leaves out, in the column's order, as {@link
     * LabPanel#parts}.
     */
    List<Runnable> sections() {
        var sections = new ArrayList<Runnable>();
        for (Group each : Group.values()) sections.add(() -> rows.add(each));
        sections.add(this::addFile);
        sections.add(this::addReadings);
        return sections;
    }

    private void addFile() {
        file = column.value("file");
        open = openButton();
        problem = area("problem", false);
    }

    private void addReadings() {
        column.heading("heading.call");
        call = area("call", true);
        column.heading("heading.difference");
        off = column.value("off");
        rounded = column.value("rounded");
        largest = column.value("largest");
        why = area("why", false);
        column.heading("heading.openGl");
        version = column.value("version");
        renderer = column.value("renderer");
        limits = column.value("limits");
        column.heading("heading.lacking");
        write(area("lacking", false), lacking());
    }

    private JButton openButton() {
        JButton button = KeyedControls.button("open", texts, this::chooseImage);
        column.wide(button);
        return button;
    }

    private void chooseImage() {
        ImageChooser.ask(SwingUtilities.getWindowAncestor(column), texts)
                .ifPresentOrElse(model::open, this::refresh);
    }

    private JTextArea area(String name, boolean program) {
        var area = new JTextArea();
        area.setName(name);
        area.setEditable(false);
        // A new text must not scroll the inspector.
        if (area.getCaret() instanceof DefaultCaret caret)
            caret.setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        area.setOpaque(false);
        area.setBorder(null);
        area.setLineWrap(true);
        area.setWrapStyleWord(true);
        area.getAccessibleContext().setAccessibleName(texts.text(name + ".said"));
        Font font = UIManager.getFont("Label.font");
        area.setFont(program ? new Font(Font.MONOSPACED, Font.PLAIN, font.getSize() - 1) : font);
        column.wide(area);
        return area;
    }

    Inspector column() {
        return column;
    }

    private static Group named(String code) {
        return Group.valueOf(code.toUpperCase(Locale.ROOT));
    }

    /** Shows the model's present state. */
    void refresh() {
        OpenGlLabState state = model.state();
        Group shown = state.touched().group();
        group.show(shown.code());
        rows.refresh(shown);
        boolean images = shown == Group.TEXTURE;
        column.showRow(file, images);
        open.setVisible(images);
        problem.setVisible(images && state.problem().isPresent());
        write(
                problem,
                state.problem()
                        .map(said -> Complaints.translated(texts.language(), said))
                        .orElse(""));
        file.setText(state.choice().file().map(image -> shortened(image.name())).orElse("–"));
        write(call, calls(state));
        compare(state);
        Optional<GlReport> report = state.report();
        version.setText(report.map(r -> firstWords(r.version())).orElse("–"));
        version.setToolTipText(report.map(GlReport::version).orElse(null));
        renderer.setText(report.map(r -> firstWords(r.renderer())).orElse("–"));
        renderer.setToolTipText(report.map(GlReport::renderer).orElse(null));
        limits.setText(
                report.map(
                                r ->
                                        texts.text(
                                                "limits.numbers",
                                                String.valueOf(r.textureSide()),
                                                r.lights(),
                                                r.modelViews()))
                        .orElse("–"));
    }

    /** The calls that the setting makes in this frame, or those it would make. */
    private String calls(OpenGlLabState state) {
        List<String> made =
                state.calls().stream()
                        .filter(each -> each.setting().equals(Optional.of(state.touched())))
                        .map(GlCall::text)
                        .map(line -> line + ";")
                        .distinct()
                        .toList();
        if (made.isEmpty()) return texts.text("call.none", state.touched().call());
        String shown = made.stream().limit(MOST_CALLS).collect(Collectors.joining("\n"));
        return made.size() > MOST_CALLS ? shown + "\n…" : shown;
    }

    private void compare(OpenGlLabState state) {
        Optional<Comparison> found = state.pictures().difference();
        off.setText(
                found.map(
                                c ->
                                        texts.text(
                                                "off.pixels",
                                                c.plain().plainlyWrongPixels(),
                                                String.format(
                                                        texts.locale(), "%.3f", 100 * c.share())))
                        .orElse("–"));
        rounded.setText(found.map(c -> texts.text("pixels", c.rounded())).orElse("–"));
        largest.setText(found.map(c -> texts.text("levels", c.largest())).orElse("–"));
        write(why, reasons(state));
    }

    private String reasons(OpenGlLabState state) {
        if (state.missing().isPresent()) return texts.text("difference.none");
        List<Deviations> named = Deviations.of(state.choice());
        if (named.isEmpty()) return texts.text("why.none");
        return named.stream()
                .map(each -> texts.text("why." + each.code()))
                .collect(Collectors.joining("\n"));
    }

    /** All that the two halves do not have in common. */
    private String lacking() {
        return Arrays.stream(Deviations.values())
                .map(each -> "• " + texts.text("why." + each.code()))
                .collect(Collectors.joining("\n"));
    }

    private static void write(JTextArea area, String text) {
        if (!area.getText().equals(text)) area.setText(text);
    }

    private static String firstWords(String text) {
        return shortened(text.replaceAll(" \\(.*?\\)", ""));
    }

    private static String shortened(String text) {
        return text.length() <= 26 ? text : text.substring(0, 25) + "…";
    }
}
