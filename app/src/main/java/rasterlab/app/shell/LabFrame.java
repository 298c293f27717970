package rasterlab.app.shell;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Frame;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.WindowConstants;
import rasterlab.app.canvas.file.LastChosen;
import rasterlab.app.canvas.lab.LabLayout;
import rasterlab.app.exercise.Closing;
import rasterlab.app.exercise.panel.ClosingDialog;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.labs.FirstCase;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabsFile;
import rasterlab.app.shell.labs.StateKeeper;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabSettings;
import rasterlab.app.shell.settings.SettingsFile;

/** The window: the labs' tabs, with theme and language switched while it is open. */
public final class LabFrame extends JFrame {
    private static final long serialVersionUID = 1L;

    private final JPanel place = new JPanel(new BorderLayout());
    private final transient LabModels models;
    private final transient StateKeeper keeper;
    private transient LabSettings settings;
    private transient Language nextLanguage;
    private transient LabTabs tabs;
    private transient Optional<Coming> coming = Optional.empty();
    private LabContent content;
    private Rectangle unmaximised;

    /**
     * A frame that is not shown yet, with tabs of its own. On the event thread, with the settings'
     * theme installed.
     *
     * @param nextLanguage kept for the next start, as long as none is chosen here
     * @param file where the settings are kept, soon after they change
     * @param labsFile where what the labs show is kept likewise
     * @param onFailure told what fails, on any thread
     */
    public LabFrame(
            LabModels models,
            LabSettings settings,
            Language nextLanguage,
            SettingsFile file,
            LabsFile labsFile,
            Consumer<Throwable> onFailure) {
        this(
                models,
                tabs(models, settings, file, onFailure),
                settings,
                nextLanguage,
                file,
                labsFile);
    }

    private static LabTabs tabs(
            LabModels models,
            LabSettings settings,
            SettingsFile file,
            Consumer<Throwable> onFailure) {
        models.keepSourcesIn(file.folder());
        return LabTabs.create(models, settings.look().language(), onFailure);
    }

    /**
     * Makes a frame with tabs that were made before, of models that keep their sources already.
     *
     * @param tabs in the settings' language
     */
    LabFrame(
            LabModels models,
            LabTabs tabs,
            LabSettings settings,
            Language nextLanguage,
            SettingsFile file,
            LabsFile labsFile) {
        this.models = models;
        this.settings = settings;
        this.nextLanguage = nextLanguage;
        LabLayout.showInspectors(settings.controls());
        settings.chosen().remember();
        setName("lab");
        setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        setMinimumSize(windowPlace().least());
        setIconImages(WindowIcon.images());
        addWindowListener(
                new WindowAdapter() {
                    @Override
                    public void windowClosing(WindowEvent e) {
                        if (mayClose()) dispose();
                    }

                    @Override
                    public void windowClosed(WindowEvent e) {
                        end();
                    }
                });
        addWindowFocusListener(new FirstFocus());
        FocusOffDisabled.in(this);
        setContentPane(place);
        fill(tabs, settings.tab());
        placeOnScreen();
        keeper = new StateKeeper(file, labsFile, this::settings, models);
    }

    public LabLook look() {
        return settings.look();
    }

    public Language language() {
        return look().language();
    }

    /** Shows a case in the tab of its topic. */
    void show(FirstCase one) {
        tabs.opening().showCase(one);
    }

    /**
     * Speaks and looks otherwise from now on: makes the tabs again; tab, focus and what plays stay.
     * A focus that was still on its way goes to the picture.
     */
    public void wear(LabLook look) {
        forgetComing();
        if (!look.equals(settings.look())) wear(look, () -> tabs.again(look.language()));
    }

    /** Tabs in the language that was chosen, until the one that is seen is made. */
    private record Coming(LabLook look, LabTabs tabs) {}

    /** Speaks the language that the user chose, and keeps it, even if it is spoken already. */
    private void choose(Language language) {
        nextLanguage = language;
        choose(look().with(language));
    }

    /**
     * Does what the user chose: as {@link #wear}, but another language is worn when the tab that is
     * seen is made in it, part by part, between which the window answers. What else is chosen
     * meanwhile is worn with that language.
     */
    private void choose(LabLook look) {
        boolean otherLanguage = look.language() != language();
        if (otherLanguage && look.equals(settings.look().with(look.language()))) {
            forgetComing();
            var next = new Coming(look, tabs.again(look.language()));
            coming = Optional.of(next);
            next.tabs().namedOrFirst(content.seen()).makeInEvents(() -> wear(next));
        } else if (otherLanguage || look.equals(settings.look())) wear(look);
        else wear(look.with(coming.map(Coming::look).orElse(look).language()));
    }

    /**
     * Puts a look on, unless something else was chosen, or the window closed, while its tabs were
     * made.
     */
    private void wear(Coming next) {
        if (!coming.equals(Optional.of(next))) return;
        coming = Optional.empty();
        wear(next.look(), next::tabs);
    }

    private void forgetComing() {
        coming.map(Coming::tabs).ifPresent(LabTabs::close);
        coming = Optional.empty();
    }

    /**
     * @param next makes or gives the tabs when the look is installed
     */
    private void wear(LabLook look, Supplier<LabTabs> next) {
        LabLook before = settings.look();
        if (look.language() != before.language()) nextLanguage = look.language();
        settings = settings.with(look);
        String focus = focused();
        String seen = content.seen();
        String chosen = content.shown();
        List<LabTabs.Doing> doing = tabs.doing();
        // Removed components need not learn the new look first.
        place.removeAll();
        tabs.close();
        if (look.theme() != before.theme() || look.textPercent() != before.textPercent()) {
            look.theme().install(look.textPercent());
            FlatLaf.updateUI();
        }
        fill(next.get(), seen);
        tabs.goOnAs(doing);
        content.show(chosen);
        giveFocus(focus);
        EventQueue.invokeLater(() -> giveFocus(focus));
        keeper.look();
    }

    /** Name of the component that has the keyboard; null where there is none. */
    private static String focused() {
        Component focused = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        return focused == null ? null : focused.getName();
    }

    /**
     * @param name of the component that is to have the keyboard; null, or one that is not there,
     *     for the picture
     */
    private void giveFocus(String name) {
        if (name == null || !FocusByName.request(content, name)) content.focusPicture();
    }

    private void fill(LabTabs next, String tab) {
        Texts texts = Texts.of("shell", language());
        setTitle(texts.text("title"));
        DialogTexts.install(language());
        tabs = next;
        content = new LabContent(tabs, tab, look(), this::choose, this::choose);
        // The frame would lay out a new content pane at once; this is an event of its own.
        place.add(content);
        place.revalidate();
        place.repaint();
    }

    private void placeOnScreen() {
        WindowPlace place = windowPlace();
        setSize(place.first());
        setLocationRelativeTo(null);
        settings.bounds()
                .filter(LabFrame::onSomeScreen)
                .ifPresent(earlier -> setBounds(place.again(earlier)));
        unmaximised = getBounds();
        if (settings.maximised()) setExtendedState(Frame.MAXIMIZED_BOTH);
    }

    private static WindowPlace windowPlace() {
        Rectangle screen =
                GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        return new WindowPlace(screen, UIScale.getUserScaleFactor());
    }

    /** Whether enough of the place lies on a screen to take hold of the window. */
    private static boolean onSomeScreen(Rectangle place) {
        for (GraphicsDevice device :
                GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices()) {
            Rectangle seen = device.getDefaultConfiguration().getBounds().intersection(place);
            if (seen.width >= 200 && seen.height >= 100) return true;
        }
        return false;
    }

    /** Asks the user where a source would be lost. */
    private boolean mayClose() {
        try {
            return Closing.allowed(models.unsavedDrafts(), new ClosingDialog(this, language()));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    /** The settings as the window stands now. */
    private LabSettings settings() {
        boolean filled = (getExtendedState() & Frame.MAXIMIZED_BOTH) == Frame.MAXIMIZED_BOTH;
        return settings.with(look().with(nextLanguage))
                .withControls(LabLayout.showsInspectors())
                .with(LastChosen.now())
                .at(content.shown(), filled ? unmaximised : getBounds(), filled);
    }

    private void end() {
        keeper.close();
        forgetComing();
        tabs.close();
        models.close();
        // Otherwise a later theme would bind the closed window's keys again and keep it in memory.
        place.removeAll();
    }

    /**
     * Gives the picture the keyboard when the window first has it; what is asked before that may be
     * overruled by the component that Swing finds first.
     */
    private final class FirstFocus extends WindowAdapter {
        @Override
        public void windowGainedFocus(WindowEvent e) {
            removeWindowFocusListener(this);
            content.focusPicture();
        }
    }
}
