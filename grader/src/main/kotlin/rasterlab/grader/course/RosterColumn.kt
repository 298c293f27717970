package rasterlab.grader.course

/**
 * Names what a column of a roster says of a student, by the headings that Moodle, Canvas and people give it.
 *
 * @param kind its name where it is kept
 * @param names whether two students of a course never have the same
 */
internal enum class RosterColumn(
    val kind: String,
    val names: Boolean,
    vararg headings: String,
) {
    CANVAS_ID("canvas-id", true, "id"),
    ID_NUMBER("id-number", true, "id number", "student id", "индивидуальный номер", "номер"),
    SIS_USER("sis-user-id", true, "sis user id"),
    SIS_LOGIN("sis-login-id", true, "sis login id"),
    USERNAME("username", true, "username", "login", "логин"),
    EMAIL("email", true, "email address", "email", "e-mail", "адрес электронной почты", "электронная почта", "почта"),
    SECTION("section", false, "section", "group", "groups", "группа", "группы"),

    /** Canvas' "Last, First", which it wants back as it was. */
    CANVAS_NAME("canvas-student", false, "student"),
    FIRST_NAME("first-name", false, "first name", "имя"),
    LAST_NAME("last-name", false, "last name", "surname", "фамилия"),
    MIDDLE_NAME("middle-name", false, "middle name", "отчество"),
    FULL_NAME("", false, "name", "full name", "full name with profile link", "фио", "ф. и. о.", "имя / фамилия"),
    ;

    private val headings = headings.toSet()

    companion object {
        /** The column that is headed so, or null: a column of marks, say. */
        fun headed(heading: String): RosterColumn? = entries.firstOrNull { heading.trim().lowercase() in it.headings }
    }
}

/** The number that the institution gave the student of whom a roster said this; null where none did. */
internal val Map<String, String>.idNumber: String? get() = get(RosterColumn.ID_NUMBER.kind)

/** The e-mail address of the student of whom a roster said this; null where none did. */
internal val Map<String, String>.email: String? get() = get(RosterColumn.EMAIL.kind)
