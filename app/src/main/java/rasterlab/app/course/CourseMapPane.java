package rasterlab.app.course;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.BorderLayout;
import java.awt.Font;
import java.awt.Rectangle;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.time.format.FormatStyle;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.lab.LargeType;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.course.ChapterTable.ChapterRow;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.course.Chapter;

/**
 * Every exercise under its topic, in the course's order: what is handed in, how long it usually
 * takes, how far the student has come and until when there is time. A click opens the exercise, or
 * the lab that prepares for it.
 */
public final class CourseMapPane extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    /** How many chapters stand side by side in a wide window. */
    private static final int ABREAST = 3;

    /** Whether what is told of an exercise stands below its title, for want of width. */
    private final boolean below = LargeType.now();

    private final transient Texts texts;
    private final transient Consumer<String> openExercise;
    private final transient Consumer<String> openLab;
    private final transient Map<String, Row> rows = new LinkedHashMap<>();
    private final WrappedText source = new WrappedText("map.source");
    private final transient List<JLabel> deadlines = new ArrayList<>();
    private final JButton back;
    private final transient Runnable noStandings;

    private record Row(JButton title, JLabel state, JLabel deadline) {}

    /**
     * @param standings how far the student has come
     * @param openExercise told the id of the exercise that is clicked
     * @param openLab told the topic whose lab is asked for
     * @param leave goes back to the exercise that was shown
     */
    public CourseMapPane(
            Standings standings,
            List<Exercise> exercises,
            Language language,
            Consumer<String> openExercise,
            Consumer<String> openLab,
            Runnable leave) {
        super(new BorderLayout());
        setName("course.map");
        texts = Texts.of("course", language);
        this.openExercise = openExercise;
        this.openLab = openLab;
        back = button("back", texts.text("back"), leave);
        var head = new JPanel(new MigLayout("insets 8 10 4 10, gap 12", "[][grow,fill]", "[]"));
        head.add(back);
        head.add(source, "wmin 0");
        add(head, BorderLayout.NORTH);
        var list = new ChapterTable(below ? 1 : ABREAST);
        if (!below) for (int i = 0; i < ABREAST; i++) addHeadings(list, i);
        for (Chapter chapter : Chapter.of(exercises)) addChapter(list, chapter);
        var scroll = new JScrollPane(list);
        scroll.setName("map.scroll");
        scroll.setBorder(null);
        scroll.getVerticalScrollBar().setUnitIncrement(24);
        add(scroll);
        KeyBinding.within(this, KeyStroke.getKeyStroke("ESCAPE"), leave);
        show(standings.knownStandings());
        noStandings = standings.listen(this::show);
    }

    private void addHeadings(ChapterTable list, int block) {
        JLabel deadline = heading("deadline", block);
        deadlines.add(deadline);
        list.addHeadings(
                List.of(
                        heading("exercise", block),
                        heading("form", block),
                        heading("minutes", block),
                        heading("state", block),
                        deadline));
    }

    private JLabel heading(String key, int block) {
        var label = new JLabel(texts.text("heading." + key));
        label.setName("map.heading." + key + (block == 0 ? "" : "." + block));
        label.putClientProperty(FlatClientProperties.STYLE_CLASS, "small");
        return label;
    }

    private void addChapter(ChapterTable list, Chapter chapter) {
        String language = texts.locale().getLanguage();
        var title = new JLabel(chapter.title(language));
        title.setName("map.topic." + chapter.topic());
        title.setFont(title.getFont().deriveFont(Font.BOLD));
        JButton lab =
                button(
                        "map.lab." + chapter.topic(),
                        texts.text("lab", chapter.labTitle(language)),
                        () -> openLab.accept(chapter.topic()));
        lab.setToolTipText(texts.text("lab.hint", chapter.labTitle(language), title.getText()));
        List<ChapterRow> lines = new ArrayList<>();
        if (below) {
            lines.add(new ChapterRow(List.of(title), true));
            lines.add(new ChapterRow(List.of(lab), true));
        } else lines.add(new ChapterRow(List.of(title, lab), true));
        chapter.exercises().forEach(one -> lines.addAll(lines(one)));
        list.addChapter(lines);
    }

    private List<ChapterRow> lines(Exercise exercise) {
        JButton title =
                button(
                        "map.exercise." + exercise.id(),
                        exercise.title(texts.locale().getLanguage()),
                        () -> openExercise.accept(exercise.id()));
        title.setHorizontalAlignment(SwingConstants.LEADING);
        title.putClientProperty(FlatClientProperties.BUTTON_TYPE, "borderless");
        var row = new Row(title, new JLabel(), new JLabel());
        row.state.setName("map.state." + exercise.id());
        row.deadline.setName("map.deadline." + exercise.id());
        rows.put(exercise.id(), row);
        var form = new JLabel(texts.text("form." + exercise.form().code()));
        var minutes = new JLabel(minutes(exercise));
        if (!below)
            return List.of(
                    new ChapterRow(List.of(title, form, minutes, row.state, row.deadline), false));
        var told = new JPanel(FlowRows.inTheMiddle(16));
        List.of(form, minutes, row.state, row.deadline).forEach(told::add);
        FlowRows.keepWrapped(told);
        return List.of(new ChapterRow(List.of(title), false), new ChapterRow(List.of(told), false));
    }

    private String minutes(Exercise exercise) {
        return exercise.minutes().isPresent()
                ? texts.text("minutes", exercise.minutes().getAsInt())
                : "";
    }

    private static JButton button(String name, String text, Runnable action) {
        var button = new JButton(text);
        button.setName(name);
        button.putClientProperty("FlatLaf.style", "minimumWidth: 0; margin: 2,6,2,6");
        button.addActionListener(e -> action.run());
        return button;
    }

    private void show(Standings.KnownStandings told) {
        source.show(texts.text("source." + told.source(), told.detail()));
        boolean timed = false;
        for (Map.Entry<String, Row> each : rows.entrySet()) {
            Standing standing = told.of(each.getKey());
            Row row = each.getValue();
            row.state.setText(state(standing));
            row.deadline.setText(standing.deadline().map(this::deadline).orElse(""));
            row.title.getAccessibleContext().setAccessibleDescription(row.state.getText());
            timed |= standing.deadline().isPresent();
        }
        String heading = timed ? texts.text("heading.deadline") : "";
        deadlines.forEach(each -> each.setText(heading));
    }

    private String state(Standing standing) {
        UnaryOperator<String> plain = key -> texts.text("state." + key);
        return switch (standing.state()) {
            case NOT_TRIED -> plain.apply("none");
            case WAITING -> plain.apply("waiting");
            case GRADED ->
                    standing.points()
                            .map(best -> texts.text("state.best", best.points(), best.of()))
                            .orElse(plain.apply("waiting"));
        };
    }

    /** The date alone in a column of deadlines. */
    private String deadline(Instant time) {
        return below ? texts.text("until", date(time)) : date(time);
    }

    private String date(Instant deadline) {
        return DateTimeFormatter.ofLocalizedDateTime(FormatStyle.SHORT)
                .withLocale(texts.locale())
                .withZone(ZoneId.systemDefault())
                .format(deadline);
    }

    /** Gives the keyboard to that exercise and brings it in sight. */
    public void focus(String exercise) {
        Row row = rows.get(exercise);
        JComponent next = row == null ? back : row.title;
        next.requestFocusInWindow();
        if (row == null) return;
        validate();
        Rectangle around = row.title.getBounds();
        around.grow(0, 4 * around.height);
        ((JComponent) row.title.getParent()).scrollRectToVisible(around);
    }

    /** Stops listening. */
    @Override
    public void close() {
        noStandings.run();
    }
}
