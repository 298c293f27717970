package rasterlab.exercises.runner;

import java.time.Duration;

/** Settings of a judge that only tests need. */
public final class OtherSettings {
    private OtherSettings() {}

    /** These settings with another limit for one call. */
    public static JudgeSettings withCallLimit(Duration limit, JudgeSettings settings) {
        return new JudgeSettings(
                settings.compileLimit(),
                limit,
                settings.runLimit(),
                settings.spares(),
                settings.speed(),
                settings.box(),
                settings.images());
    }

    /** The settings of a program that grades once, with process limits only. */
    public static JudgeSettings onceInNoBox() {
        JudgeSettings once = JudgeSettings.once();
        return new JudgeSettings(
                once.compileLimit(),
                once.callLimit(),
                once.runLimit(),
                once.spares(),
                once.speed(),
                JudgeSettings.Protection.PROCESS_LIMITS_ONLY,
                once.images());
    }
}
