module geminga.project {
    requires geminga;
}
