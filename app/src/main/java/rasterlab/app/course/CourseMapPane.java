package rasterlab.app.course;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Rectangle;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.time.format.FormatStyle;
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
import javax.swing.Scrollable;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.lab.LargeType;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.canvas.widget.WrappedText;
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

    private static final int COLUMNS = 5;

    /** Whether what is told of an exercise stands below its title, for want of width. */
    private final boolean below = LargeType.now();

    private final transient Texts texts;
    private final transient Consumer<String> openExercise;
    private final transient Consumer<String> openLab;
    private final transient Map<String, Row> rows = new LinkedHashMap<>();
    private final WrappedText source = new WrappedText("map.source");
    private final JLabel deadlines = new JLabel();
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
        var list = new WideList();
        if (!below) addHeadings(list);
        for (Chapter chapter : Chapter.of(exercises)) addChapter(list, chapter);
        var scroll = new JScrollPane(list);
        scroll.setName("map.scroll");
        scroll.setBorder(null);
        scroll.getVerticalScrollBar().setUnitIncrement(24);
        add(scroll);
        KeyBinding.within(this, KeyStroke.getKeyStroke("ESCAPE"), leave);
        show(standings.told());
        noStandings = standings.listen(this::show);
    }

    private void addHeadings(JPanel list) {
        list.add(heading("exercise"));
        list.add(heading("form"));
        list.add(heading("minutes"));
        list.add(heading("state"));
        deadlines.setName("map.heading.deadline");
        deadlines.putClientProperty(FlatClientProperties.STYLE_CLASS, "small");
        list.add(deadlines);
    }

    private JLabel heading(String key) {
        var label = new JLabel(texts.text("heading." + key));
        label.setName("map.heading." + key);
        label.putClientProperty(FlatClientProperties.STYLE_CLASS, "small");
        return label;
    }

    private void addChapter(JPanel list, Chapter chapter) {
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
        if (below) {
            list.add(title, "newline, span, gaptop 14, wmin 0");
            list.add(lab, "newline, span, growx 0, wmin 0");
        } else {
            list.add(title, "newline, gaptop 14, wmin 0");
            list.add(lab, "span " + (COLUMNS - 1) + ", gaptop 14, wmin 0");
        }
        chapter.exercises().forEach(one -> addExercise(list, one));
    }

    private void addExercise(JPanel list, Exercise exercise) {
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
        List<JLabel> told =
                List.of(
                        new JLabel(texts.text("form." + exercise.form().code())),
                        new JLabel(minutes(exercise)),
                        row.state,
                        row.deadline);
        if (below) {
            list.add(title, "newline, span, gapleft 10, wmin 0");
            var line = new JPanel(FlowRows.inTheMiddle(16));
            told.forEach(line::add);
            FlowRows.keepWrapped(line);
            list.add(line, "newline, span, gapleft 16, wmin 0");
        } else {
            list.add(title, "newline, gapleft 10, wmin 0");
            told.forEach(label -> list.add(label, "wmin 0"));
        }
        rows.put(exercise.id(), row);
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

    private void show(Standings.Told told) {
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
        deadlines.setText(timed ? texts.text("heading.deadline") : "");
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

    /**
     * Fits the width that there is: a long title is shortened, nothing is to be scrolled sideways.
     */
    private static final class WideList extends JPanel implements Scrollable {
        private static final long serialVersionUID = 1L;

        WideList() {
            super(
                    new MigLayout(
                            "insets 4 10 12 16, gap 16 1, wrap " + COLUMNS,
                            LargeType.now() ? "[grow,fill][][][][]" : "[fill][][][][grow]"));
        }

        @Override
        public Dimension getPreferredScrollableViewportSize() {
            return getPreferredSize();
        }

        @Override
        public int getScrollableUnitIncrement(Rectangle seen, int orientation, int direction) {
            return 24;
        }

        @Override
        public int getScrollableBlockIncrement(Rectangle seen, int orientation, int direction) {
            return seen.height;
        }

        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true;
        }

        @Override
        public boolean getScrollableTracksViewportHeight() {
            return false;
        }
    }
}
