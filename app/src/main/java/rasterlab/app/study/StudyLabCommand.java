package rasterlab.app.study;

import rasterlab.app.language.Language;

/** The shell command that measures what the tab shows. */
final class StudyLabCommand {
    private StudyLabCommand() {}

    static String of(StudyLabState state, Language language) {
        String topic = state.topic().name();
        if (state.view() == StudyView.HAZARDS) return "./lab hazards " + topic;
        return "./lab study %s%s%s --out study-%s.svg"
                .formatted(
                        topic,
                        state.thorough() ? "" : " --quick",
                        language == Language.RUSSIAN ? " --lang ru" : "",
                        topic);
    }
}
