# The Debian packages: tools/package. CPack rather than debhelper makes them from the build that was tested, and each thing is given its
# package where it is installed. A component of install() is a package. What only a package has (units,
# /etc, Debian's documents) is left out of `cmake --install`.
if(NOT GEMINGA_BUILD_TESTS AND NOT GEMINGA_BUILD_PACKAGES OR GEMINGA_SANITIZE)
  return()
endif()
find_program(GEMINGA_GZIP gzip REQUIRED)
set(here ${CMAKE_CURRENT_LIST_DIR})
set(made ${PROJECT_BINARY_DIR}/packaging)
file(MAKE_DIRECTORY ${made})

# in_package(PACKAGE DESTINATION file...): files that only the package has.
function(in_package package destination)
  install(FILES ${ARGN} DESTINATION ${destination} COMPONENT ${package} EXCLUDE_FROM_ALL)
endfunction()

# compressed(INPUT OUTPUT): without name and time, so that the same input gives the same octets.
function(compressed input output)
  execute_process(COMMAND ${GEMINGA_GZIP} -9n INPUT_FILE ${input} OUTPUT_FILE ${output} COMMAND_ERROR_IS_FATAL ANY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${input})
endfunction()

configure_file(${here}/changelog.in ${made}/changelog @ONLY)
compressed(${made}/changelog ${made}/changelog.gz)
compressed(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${made}/CHANGELOG.md.gz)

# geminga_package(PACKAGE [ALL] SUMMARY text DESCRIPTION text [SECTION section] [DEPENDS text] [RECOMMENDS text] [SUGGESTS text]
#                 [CONTROL file...]): what control says of a package. ALL: it holds nothing for one kind of processor. Lines of the
# description begin with a blank, as Debian's policy has it (5.6.13).
set(packages "")
macro(geminga_package package)
  cmake_parse_arguments(this "ALL" "SUMMARY;DESCRIPTION;SECTION;DEPENDS;RECOMMENDS;SUGGESTS" "CONTROL" ${ARGN})
  list(APPEND packages ${package})
  string(TOUPPER ${package} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${this_SUMMARY}\n${this_DESCRIPTION}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${this_SECTION})
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${this_DEPENDS}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_RECOMMENDS "${this_RECOMMENDS}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_SUGGESTS "${this_SUGGESTS}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA "${this_CONTROL}")
  if(this_ALL)
    set(CPACK_DEBIAN_${upper}_PACKAGE_ARCHITECTURE all)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS OFF)
  endif()
  in_package(${package} ${CMAKE_INSTALL_DATADIR}/doc/${package} ${here}/copyright ${made}/changelog.gz)
  if(EXISTS ${here}/overrides/${package})
    in_package(${package} ${CMAKE_INSTALL_DATADIR}/lintian/overrides ${here}/overrides/${package})
  endif()
endmacro()

geminga_package(geminga
  SUMMARY "service discovery for teams of mobile robots"
  DESCRIPTION "One daemon a host tells the modules of a robot who in the team offers what
they ask for. Daemons multicast compact announcements, keep what they hear
until its deadline, and match locally. There is no server and no
configuration. Services are numbers, texts, or concepts of an ontology.
.
This package has the daemon with its systemd unit, geminga-query,
geminga-publish, geminga-subscribe, and a dissector for Wireshark with
geminga-unseal, which opens sealed datagrams of a recording."
  SECTION net
  DEPENDS "procps, systemd-standalone-sysusers | systemd"
  RECOMMENDS "geminga-ontologies (= ${PROJECT_VERSION}), geminga-ontology (= ${PROJECT_VERSION})"
  CONTROL ${here}/control/geminga/conffiles ${here}/control/geminga/postinst ${here}/control/geminga/prerm
          ${here}/control/geminga/postrm)
in_package(geminga lib/systemd/system ${here}/gemingad.service ${here}/gemingad.socket ${here}/geminga-adopt.service)
install(FILES ${here}/geminga.sysusers DESTINATION lib/sysusers.d RENAME geminga.conf COMPONENT geminga EXCLUDE_FROM_ALL)
in_package(geminga /etc/geminga ${here}/gemingad.toml)
in_package(geminga /etc/geminga/conf.d ${here}/conf.d/README)
in_package(geminga ${CMAKE_INSTALL_DATADIR}/doc/geminga ${made}/CHANGELOG.md.gz ${PROJECT_SOURCE_DIR}/GUIDE.md)

geminga_package(geminga-ontology
  SUMMARY "reasoner and compiler of ontologies for robot teams"
  DESCRIPTION "geminga-ontology checks, classifies, explains, queries and draws OWL 2
ontologies in six syntaxes, and compiles them for gemingad, which reads
no RDF itself: without this package it takes compiled files only."
  SECTION science
  RECOMMENDS "geminga-ontologies (= ${PROJECT_VERSION})"
  SUGGESTS "graphviz, wordnet-base")

geminga_package(geminga-web
  SUMMARY "metrics, health and live answers of a robot team over HTTP"
  DESCRIPTION "geminga-web asks the daemon of its host and serves OpenMetrics, probes of
health, JSON and server-sent events, on 127.0.0.1 unless told. Alert rules
for Prometheus come with it. Its service is off until it is enabled."
  SECTION net
  DEPENDS "geminga (= ${PROJECT_VERSION})"
  SUGGESTS "prometheus"
  CONTROL ${here}/control/geminga-web/conffiles ${here}/control/geminga-web/postinst ${here}/control/geminga-web/prerm
          ${here}/control/geminga-web/postrm)
in_package(geminga-web lib/systemd/system ${here}/geminga-web.service)
install(FILES ${here}/geminga-web.default DESTINATION /etc/default RENAME geminga-web COMPONENT geminga-web EXCLUDE_FROM_ALL)
in_package(geminga-web ${CMAKE_INSTALL_DATADIR}/doc/geminga-web/examples ${PROJECT_SOURCE_DIR}/examples/monitoring/prometheus.yml
           ${PROJECT_SOURCE_DIR}/examples/monitoring/geminga.rules.yml ${PROJECT_SOURCE_DIR}/examples/monitoring/geminga.rules_test.yml
           ${PROJECT_SOURCE_DIR}/examples/monitoring/README.md)

geminga_package(geminga-bridge
  SUMMARY "bridges between a robot team and the services of others"
  DESCRIPTION "geminga-bridge KIND starts the bridge of a kind, which is in the package
geminga-bridge-KIND."
  SECTION net
  RECOMMENDS "geminga (= ${PROJECT_VERSION})"
  SUGGESTS "geminga-bridge-dds, geminga-bridge-dns-sd, geminga-bridge-mqtt, geminga-bridge-nats")

# bridge_unit(KIND SUMMARY text DEFAULT file [AFTER unit] [GROUPS group] [SECURE scheme] [LASTING_USER]): the unit of a kind of bridge, which is off
# until it is enabled, its flags in /etc/default, and its maintainer scripts, in ${control}. LASTING_USER: its user is there for good, as D-Bus wants it,
# which refuses users that are there while a unit runs.
macro(bridge_unit kind)
  cmake_parse_arguments(this "LASTING_USER" "SUMMARY;DEFAULT;AFTER;GROUPS;SECURE" "" ${ARGN})
  set(at @)
  set(unit geminga-bridge-${kind})
  set(summary ${this_SUMMARY})
  set(secure ${this_SECURE})
  set(after "")
  if(this_AFTER)
    set(after " ${this_AFTER}")
  endif()
  set(groups "")
  if(this_GROUPS)
    set(groups "# The group may use the GCNP socket.\nSupplementaryGroups=${this_GROUPS}\n")
  endif()
  set(user "# A user of its own while it runs.\nDynamicUser=yes")
  if(this_LASTING_USER)
    set(user "# A user of its own, which is there for good: D-Bus refuses others.\nUser=${unit}")
    file(CONFIGURE OUTPUT ${made}/${unit}/sysusers CONTENT "u ${unit} - \"${this_SUMMARY}\"\n")
    install(FILES ${made}/${unit}/sysusers DESTINATION lib/sysusers.d RENAME ${unit}.conf COMPONENT ${unit} EXCLUDE_FROM_ALL)
  endif()
  configure_file(${here}/bridge/bridge.service.in ${made}/${unit}.service @ONLY)
  configure_file(${here}/bridge/${this_DEFAULT}.default.in ${made}/${unit}/default @ONLY)
  set(control "")
  foreach(file conffiles postinst prerm postrm)
    configure_file(${here}/bridge/${file}.in ${made}/${unit}/${file} @ONLY)
    list(APPEND control ${made}/${unit}/${file})
  endforeach()
  in_package(${unit} lib/systemd/system ${made}/${unit}.service)
  install(FILES ${made}/${unit}/default DESTINATION /etc/default RENAME ${unit} COMPONENT ${unit} EXCLUDE_FROM_ALL)
endmacro()

if(TARGET geminga-bridge-dns-sd)
  bridge_unit(dns-sd SUMMARY "Geminga beside DNS-SD" DEFAULT client AFTER avahi-daemon.service GROUPS geminga LASTING_USER)
  geminga_package(geminga-bridge-dns-sd
    SUMMARY "bridge between a robot team and DNS-SD"
    DESCRIPTION "Announces the services of a team by DNS-SD, with concept and
representation in the TXT record, and states what printers, cameras and
computers announce as services of the team. It goes through avahi-daemon.
Its service is off until it is enabled."
    SECTION net
    DEPENDS "geminga (= ${PROJECT_VERSION}), geminga-bridge (= ${PROJECT_VERSION}), avahi-daemon"
    CONTROL ${control})
endif()

if(TARGET geminga-bridge-dds)
  bridge_unit(dds SUMMARY "Geminga beside DDS and ROS 2" DEFAULT client GROUPS geminga)
  geminga_package(geminga-bridge-dds
    SUMMARY "bridge between a robot team and DDS"
    DESCRIPTION "Shows the readers and writers of a DDS domain to a team as requests and
services, with the names, types and policies of ROS 2. It carries no
messages. Its service is off until it is enabled."
    SECTION net
    DEPENDS "geminga (= ${PROJECT_VERSION}), geminga-bridge (= ${PROJECT_VERSION})"
    CONTROL ${control})
endif()

if(TARGET geminga-bridge-mqtt)
  bridge_unit(mqtt SUMMARY "Geminga over a server of MQTT" DEFAULT words SECURE mqtts)
  geminga_package(geminga-bridge-mqtt
    SUMMARY "bridge between robot teams over MQTT"
    DESCRIPTION "Carries the announcements of daemons that have no other link over a server
of MQTT. They stay sealed with the team's key. Its service is off until it is
enabled."
    SECTION net
    DEPENDS "geminga-bridge (= ${PROJECT_VERSION})"
    SUGGESTS "mosquitto"
    CONTROL ${control})
endif()

if(TARGET geminga-bridge-nats)
  bridge_unit(nats SUMMARY "Geminga over a server of NATS" DEFAULT words SECURE tls)
  geminga_package(geminga-bridge-nats
    SUMMARY "bridge between robot teams over NATS"
    DESCRIPTION "Carries the announcements of daemons that have no other link over a server
of NATS. They stay sealed with the team's key. Its service is off until it is
enabled."
    SECTION net
    DEPENDS "geminga-bridge (= ${PROJECT_VERSION})"
    SUGGESTS "nats-server"
    CONTROL ${control})
endif()

geminga_package(geminga-ontologies ALL
  SUMMARY "ontologies for robot teams"
  DESCRIPTION "The words for services that Geminga ships: the core, a robot soccer team,
a rescue team, and what others offer by DNS-SD and ROS 2, in Turtle."
  SECTION science)

geminga_package(libgeminga1
  SUMMARY "service discovery for teams of mobile robots (C library)"
  DESCRIPTION "Programs in C offer and ask for services with it, and send and receive
messages. It speaks with the daemon of the package geminga."
  SECTION libs
  RECOMMENDS "geminga"
  CONTROL ${here}/control/libgeminga1/symbols ${here}/control/libgeminga1/shlibs ${here}/control/libgeminga1/triggers)

geminga_package(libgeminga-dev
  SUMMARY "service discovery for teams of mobile robots (development files)"
  DESCRIPTION "Headers for C++20 and C, the static C++ library as the CMake package
Geminga, and geminga for pkg-config."
  SECTION libdevel
  DEPENDS "libgeminga1 (= ${PROJECT_VERSION}), libsodium-dev, libxxhash-dev")

geminga_package(python3-geminga ALL
  SUMMARY "service discovery for teams of mobile robots (Python 3)"
  DESCRIPTION "Programs in Python offer and ask for services with it, and send and receive
messages, blocking or with asyncio."
  SECTION python
  DEPENDS "python3 (>= 3.11)"
  RECOMMENDS "geminga, python3-cryptography"
  CONTROL ${here}/control/python3-geminga/postinst ${here}/control/python3-geminga/prerm)

geminga_package(libgeminga-java ALL
  SUMMARY "service discovery for teams of mobile robots (Java)"
  DESCRIPTION "Programs in Java 17 offer and ask for services with it, and send and
receive messages."
  SECTION java
  RECOMMENDS "geminga, default-jre-headless (>= 2:1.17)")

geminga_package(node-geminga ALL
  SUMMARY "service discovery for teams of mobile robots (Node.js)"
  DESCRIPTION "Programs in JavaScript and TypeScript offer and ask for services with it,
and send and receive messages."
  SECTION javascript
  DEPENDS "nodejs (>= 18.13)"
  RECOMMENDS "geminga")

# The targets that packages hold.
get_property(manuals GLOBAL PROPERTY geminga_manuals)
add_custom_target(packaged)
foreach(target gemingad geminga-ontology geminga-query geminga-publish geminga-subscribe geminga-unseal geminga-web geminga-bridge geminga-bridge-dds geminga-bridge-dns-sd
        geminga-bridge-mqtt geminga-bridge-nats geminga-dissector ${manuals} geminga client_java)
  if(TARGET ${target})
    add_dependencies(packaged ${target})
  endif()
endforeach()
foreach(module IN LISTS geminga_client_modules)
  string(REPLACE "/" "_" module ${module})
  add_dependencies(packaged geminga_${module})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME geminga)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR Geminga)
set(CPACK_PACKAGE_CONTACT "Geminga developers <geminga@packages.geminga.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_SET_DESTDIR ON)
file(WRITE ${made}/surroundings.cmake "set(ENV{SOURCE_DATE_EPOCH} $ENV{SOURCE_DATE_EPOCH})\n")
if(CMAKE_CROSSCOMPILING)
  # dpkg-shlibdeps finds libraries and their packages in the sysroot (tools/dev/sysroot).
  file(APPEND ${made}/surroundings.cmake "set(ENV{DPKG_ADMINDIR} ${CMAKE_SYSROOT}/var/lib/dpkg)\nset(ENV{DEB_HOST_ARCH} arm64)\n")
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_SYSROOT}/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE})
  set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE arm64)
  set(CPACK_READELF_EXECUTABLE aarch64-linux-gnu-readelf)
endif()
set(CPACK_PROJECT_CONFIG_FILE ${made}/surroundings.cmake)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL ${packages})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SOURCE geminga)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
include(CPack)
